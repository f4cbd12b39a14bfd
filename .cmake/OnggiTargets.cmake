# Most of a small file's compile time goes into its headers. So several files of a target are compiled as one;
# names that would collide are changed, or the file is compiled separately (APART). OFF compiles every file
# separately: this proves that each includes what it needs, and an edit recompiles one file (preset dev).
option(ONGGI_BATCHES "Compile the files of a target in batches" ON)
set(ONGGI_BATCH_SIZE 16)

# onggi_batches(NAME RESULT SOURCES ... APART ...): sets RESULT to the sources that the target NAME compiles.
# Files that are APART or have vector loops are not batched, with every compiler, so that all compilers see
# the same batches. A batch includes its files by paths relative to the checkout, so that ccache works across
# checkouts.
function(onggi_batches NAME RESULT)
    cmake_parse_arguments(ARG "" "" "SOURCES;APART" ${ARGN})
    set(files)
    set(others)
    foreach(file IN LISTS ARG_SOURCES)
        get_source_file_property(stands_apart ${file} ONGGI_STANDS_APART)
        if(stands_apart OR file IN_LIST ARG_APART OR NOT file MATCHES "\\.cpp$")
            list(APPEND others ${file})
        else()
            list(APPEND files ${file})
        endif()
    endforeach()
    list(LENGTH files count)
    if(NOT ONGGI_BATCHES OR count LESS 2)
        set(${RESULT} ${ARG_SOURCES} PARENT_SCOPE)
        return()
    endif()
    # The smallest number of batches, of nearly equal size.
    math(EXPR batches "(${count} + ${ONGGI_BATCH_SIZE} - 1) / ${ONGGI_BATCH_SIZE}")
    math(EXPR size "(${count} + ${batches} - 1) / ${batches}")
    set(made)
    math(EXPR last "${count} - 1")
    foreach(first RANGE 0 ${last} ${size})
        list(SUBLIST files ${first} ${size} together)
        if(NOT together)
            break()
        endif()
        set(text "")
        foreach(file IN LISTS together)
            get_filename_component(file ${file} ABSOLUTE)
            file(RELATIVE_PATH file ${CMAKE_SOURCE_DIR} ${file})
            string(APPEND text "#include \"${file}\"\n")
        endforeach()
        list(LENGTH made number)
        set(batch ${CMAKE_CURRENT_BINARY_DIR}/${NAME}_batch_${number}.cpp)
        file(CONFIGURE OUTPUT ${batch} CONTENT "${text}" @ONLY)
        list(APPEND made ${batch})
    endforeach()
    set(${RESULT} ${made} ${others} PARENT_SCOPE)
endfunction()

# onggi_library(NAME SOURCES ... APART ... LINKS ... PRIVATE_LINKS ...): the library of a room. APART: sources
# that are always compiled separately.
function(onggi_library NAME)
    cmake_parse_arguments(ARG "" "" "SOURCES;APART;LINKS;PRIVATE_LINKS" ${ARGN})
    if(ARG_SOURCES)
        onggi_batches(${NAME} sources SOURCES ${ARG_SOURCES} APART ${ARG_APART})
        add_library(${NAME} STATIC ${sources})
        target_link_libraries(${NAME} PUBLIC onggi_options ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS})
    else()
        add_library(${NAME} INTERFACE)
        target_link_libraries(${NAME} INTERFACE onggi_options ${ARG_LINKS})
    endif()
endfunction()

# onggi_vector_loops(FILE...): marks files whose loops GCC should vectorise. It does so only without path
# splitting and without trapping-math guards; neither affects results. Call it before the target is created.
function(onggi_vector_loops)
    set_source_files_properties(${ARGN} PROPERTIES ONGGI_STANDS_APART ON)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS "-fno-thread-jumps;-fno-trapping-math")
    endif()
endfunction()

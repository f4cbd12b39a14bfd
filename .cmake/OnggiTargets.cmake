# Most of what a small file costs is reading the headers it includes. So several files of a target are compiled as one,
# and files whose names would collide have better names or stand apart. Off, every file is compiled by itself: which
# proves that each includes what it needs, and an edit compiles one file (preset dev).
option(ONGGI_BATCHES "Compile the files of a target in batches" ON)
set(ONGGI_BATCH_SIZE 16)

# onggi_batches(NAME RESULT SOURCES ... APART ...): the sources as the target NAME compiles them. Those of them that are
# APART, or have vector loops, stay as they are, with whichever compiler: so all of them see the same batches. A batch
# names its files from the root of the checkout, never by absolute paths, so that ccache finds it again in another one.
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
    # As many batches as are needed, of the same size as nearly as can be.
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

# onggi_library(NAME SOURCES ... APART ... LINKS ... PRIVATE_LINKS ...): a room of the house. APART: those of its sources
# that are never compiled together with others.
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

# onggi_vector_loops(FILE...): the loops of these are written to be worked on several elements at once. GCC takes them
# so only if it neither splits them into paths nor guards against traps that nobody has set; no result depends on either.
# Called before the target is made.
function(onggi_vector_loops)
    set_source_files_properties(${ARGN} PROPERTIES ONGGI_STANDS_APART ON)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS "-fno-thread-jumps;-fno-trapping-math")
    endif()
endfunction()

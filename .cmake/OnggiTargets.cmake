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

# Unoptimised, or under sanitizers, whatever a test does takes several times as long.
set(ONGGI_UNOPTIMISED OFF)
set(ONGGI_PATIENCE 1)
# What a test does itself need not be fast, unless speed is what it is about.
set(ONGGI_TEST_OPTIONS)
if(CMAKE_BUILD_TYPE STREQUAL "Release")
    set(ONGGI_TEST_OPTIONS -O1)
endif()
if(CMAKE_BUILD_TYPE STREQUAL "Debug" OR ONGGI_SANITIZE)
    set(ONGGI_UNOPTIMISED ON)
    set(ONGGI_PATIENCE 4)
endif()

# Of what is left to read for one test, a third is the same in all: GoogleTest and what stands around it. It is read once.
# Not where every file is compiled by itself: what a test includes has to be enough.
function(onggi_read_test_headers_once)
    file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/tests/headers.cpp CONTENT "// The headers alone, precompiled.\n")
    add_library(onggi_test_headers OBJECT ${CMAKE_BINARY_DIR}/tests/headers.cpp)
    target_link_libraries(onggi_test_headers PRIVATE onggi_options GTest::gtest)
    # As the tests that read it are compiled: it fits no others.
    set_target_properties(onggi_test_headers PROPERTIES POSITION_INDEPENDENT_CODE OFF)
    target_compile_options(onggi_test_headers PRIVATE -fPIE ${ONGGI_TEST_OPTIONS})
    target_precompile_headers(onggi_test_headers PRIVATE
        <gtest/gtest.h> <algorithm> <array> <chrono> <cmath> <filesystem> <functional> <memory> <optional> <random> <span>
        <string> <string_view> <thread> <variant> <vector> [["engine/math/math.h"]])
endfunction()

# onggi_test_program(NAME SOURCES ... APART ... LINKS ... FAST): a program in build/<preset>/tests that a test is, or calls.
# APART: as in onggi_library. FAST: as optimised as what ships.
function(onggi_test_program NAME)
    cmake_parse_arguments(ARG "FAST" "" "SOURCES;APART;LINKS" ${ARGN})
    onggi_batches(${NAME} sources SOURCES ${ARG_SOURCES} APART ${ARG_APART})
    add_executable(${NAME} ${sources})
    target_link_libraries(${NAME} PRIVATE onggi_program ${ARG_LINKS})
    set_target_properties(${NAME} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
    if(ARG_FAST)
        return()
    endif()
    target_compile_options(${NAME} PRIVATE ${ONGGI_TEST_OPTIONS})
    if(TARGET onggi_test_headers AND GTest::gtest IN_LIST ARG_LINKS)
        target_precompile_headers(${NAME} REUSE_FROM onggi_test_headers)
    endif()
endfunction()

# onggi_test(NAME SOURCES ... APART ... LINKS ... LABELS ... TIMEOUT seconds LASTS seconds ENVIRONMENT ...): one
# GoogleTest program, one ctest entry. APART: as in onggi_library. LASTS: about how long, of a long one, which then begins
# before the short ones and is not alone at the end. Labels: unit, paper, studio, haptics, replay, golden, device, export,
# stress, house, cli, install, window, tools, swiftshader, gpu, nightly; and picture for what draws with Vulkan outside
# golden.
function(onggi_test NAME)
    cmake_parse_arguments(ARG "" "TIMEOUT;LASTS" "SOURCES;APART;LINKS;LABELS;ENVIRONMENT" ${ARGN})
    set(fast)
    if("bench" IN_LIST ARG_LABELS)
        set(fast FAST)
    endif()
    onggi_test_program(${NAME} ${fast} SOURCES ${ARG_SOURCES} APART ${ARG_APART}
        LINKS onggi_places ${ARG_LINKS} GTest::gtest GTest::gtest_main)
    if(NOT ARG_TIMEOUT)
        set(ARG_TIMEOUT 120)
    endif()
    math(EXPR limit_s "${ARG_TIMEOUT} * ${ONGGI_PATIENCE}")
    add_test(NAME ${NAME} COMMAND ${NAME})
    set_tests_properties(${NAME} PROPERTIES TIMEOUT ${limit_s} LABELS "${ARG_LABELS}" ENVIRONMENT "${ARG_ENVIRONMENT}")
    if(ARG_LASTS)
        set_property(TEST ${NAME} PROPERTY COST ${ARG_LASTS})
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

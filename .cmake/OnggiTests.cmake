# Compiles and registers tests. tests/tests.txt lists each test's size and duration; the time limit is the
# duration scaled by the speed of this machine and build.

# A test's own code need not be fast, except in tests of speed.
set(ONGGI_TEST_OPTIONS)
if(CMAKE_BUILD_TYPE STREQUAL "Release")
    set(ONGGI_TEST_OPTIONS -O1)
endif()

# onggi_measure_slowness(): sets ONGGI_SLOWNESS, the ratio of this machine's test durations to those in
# tests/tests.txt, at least 1. Measured at each configuration with a known piece of work, compiled with the
# tests' options.
function(onggi_measure_slowness)
    set(reference_ms 250)
    set(source ${CMAKE_SOURCE_DIR}/tests/support/known_work.cpp)
    set(program ${CMAKE_BINARY_DIR}/tests/known_work)
    string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
    get_target_property(options onggi_options INTERFACE_COMPILE_OPTIONS)
    list(FILTER options INCLUDE REGEX "^-(f|O)")
    list(FILTER options EXCLUDE REGEX "fuzzer-no-link")
    separate_arguments(flags UNIX_COMMAND "${CMAKE_CXX_FLAGS_${type}}")
    if(ONGGI_FUZZ)
        list(APPEND options -fsanitize=address,undefined)
    endif()
    if(NOT EXISTS ${program} OR ${source} IS_NEWER_THAN ${program})
        execute_process(COMMAND ${CMAKE_CXX_COMPILER} -std=c++20 ${flags} ${options} ${source} -o ${program}
            COMMAND_ERROR_IS_FATAL ANY)
    endif()
    execute_process(COMMAND ${CMAKE_CROSSCOMPILING_EMULATOR} ${program} OUTPUT_VARIABLE took_ms OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    math(EXPR hundredths "${took_ms} * 100 / ${reference_ms}")
    if(hundredths LESS 100)
        set(hundredths 100)
    endif()
    math(EXPR whole "${hundredths} / 100")
    math(EXPR part "${hundredths} % 100 + 100")
    string(SUBSTRING "${part}" 1 2 part)
    message(STATUS "tests: known work took ${took_ms} ms, ${reference_ms} on the machine of tests/tests.txt: "
        "tests may take ${whole}.${part} times as long, and ten times that")
    set(ONGGI_SLOWNESS ${whole}.${part} PARENT_SCOPE)
    set(ONGGI_SLOWNESS_HUNDREDTHS ${hundredths} PARENT_SCOPE)
endfunction()

# onggi_read_test_table(): sets ONGGI_SIZE_OF_<test> and ONGGI_SECONDS_OF_<test> for each line of tests/tests.txt.
function(onggi_read_test_table)
    set(table ${CMAKE_SOURCE_DIR}/tests/tests.txt)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${table})
    file(STRINGS ${table} lines REGEX "^[^#]")
    foreach(line IN LISTS lines)
        if(NOT line MATCHES "^([a-zA-Z0-9_]+) +(basic|landing|release|nightly) +([0-9]+)$")
            message(FATAL_ERROR "tests/tests.txt: expected 'name basic|landing|release|nightly seconds', found '${line}'")
        endif()
        set(ONGGI_SIZE_OF_${CMAKE_MATCH_1} ${CMAKE_MATCH_2} PARENT_SCOPE)
        set(ONGGI_SECONDS_OF_${CMAKE_MATCH_1} ${CMAKE_MATCH_3} PARENT_SCOPE)
    endforeach()
endfunction()

# onggi_register(NAME COMMAND ... LABELS ... ENVIRONMENT ... PROPERTIES ...): a test of tests/tests.txt. It
# also gets the label of its size, and ONGGI_SLOWNESS in its environment, by which real-time tests scale their
# timeouts. Its limit is ten times its duration here, at least a minute.
function(onggi_register NAME)
    cmake_parse_arguments(ARG "" "" "COMMAND;LABELS;ENVIRONMENT;PROPERTIES" ${ARGN})
    if(NOT DEFINED ONGGI_SIZE_OF_${NAME})
        message(FATAL_ERROR "tests/tests.txt: expected a line for the test ${NAME}, found none")
    endif()
    set(seconds ${ONGGI_SECONDS_OF_${NAME}})
    math(EXPR limit_s "${seconds} * ${ONGGI_SLOWNESS_HUNDREDTHS} / 10")
    math(EXPR least_s "60 * ${ONGGI_SLOWNESS_HUNDREDTHS} / 100")
    if(limit_s LESS least_s)
        set(limit_s ${least_s})
    endif()
    list(APPEND ARG_ENVIRONMENT "ONGGI_SLOWNESS=${ONGGI_SLOWNESS}")
    if(ONGGI_SANITIZE)
        # Ignore leaks of third-party libraries.
        list(APPEND ARG_ENVIRONMENT
            "LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/tests/support/lsan.supp:print_suppressions=0")
    endif()
    add_test(NAME ${NAME} COMMAND ${ARG_COMMAND})
    set_tests_properties(${NAME} PROPERTIES TIMEOUT ${limit_s} COST ${seconds} LABELS "${ARG_LABELS};${ONGGI_SIZE_OF_${NAME}}"
        ENVIRONMENT "${ARG_ENVIRONMENT}" ${ARG_PROPERTIES})
endfunction()

# Precompiles GoogleTest and other common headers, a third of a test's compile time. Not if every file is
# compiled separately, because a test must include what it needs.
function(onggi_read_test_headers_once)
    file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/tests/headers.cpp CONTENT "// The headers alone, precompiled.\n")
    add_library(onggi_test_headers OBJECT ${CMAKE_BINARY_DIR}/tests/headers.cpp)
    target_link_libraries(onggi_test_headers PRIVATE onggi_options GTest::gtest)
    # Compiled with the tests' options, because a precompiled header requires identical ones.
    set_target_properties(onggi_test_headers PROPERTIES POSITION_INDEPENDENT_CODE OFF)
    target_compile_options(onggi_test_headers PRIVATE -fPIE ${ONGGI_TEST_OPTIONS})
    target_precompile_headers(onggi_test_headers PRIVATE
        <gtest/gtest.h> <algorithm> <array> <chrono> <cmath> <filesystem> <functional> <memory> <optional> <random> <span>
        <string> <string_view> <thread> <variant> <vector> [["engine/math/math.h"]])
endfunction()

# onggi_test_program(NAME SOURCES ... APART ... LINKS ... FAST): a test program or helper in
# build/<preset>/tests. APART: as in onggi_library. FAST: optimised like the shipped program.
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

# onggi_test(NAME SOURCES ... APART ... LINKS ... LABELS ... ENVIRONMENT ... PROPERTIES ...): a GoogleTest
# program and its one test. APART: as in onggi_library. Labels: unit, paper, studio, haptics, replay, golden,
# device, export, stress, house, cli, install, window, tools, swiftshader, gpu, nightly; and picture for other
# tests that draw with Vulkan.
function(onggi_test NAME)
    cmake_parse_arguments(ARG "" "" "SOURCES;APART;LINKS;LABELS;ENVIRONMENT;PROPERTIES" ${ARGN})
    set(fast)
    if("bench" IN_LIST ARG_LABELS)
        set(fast FAST)
    endif()
    onggi_test_program(${NAME} ${fast} SOURCES ${ARG_SOURCES} APART ${ARG_APART}
        LINKS onggi_places ${ARG_LINKS} GTest::gtest GTest::gtest_main)
    onggi_register(${NAME} COMMAND ${NAME} LABELS ${ARG_LABELS} ENVIRONMENT ${ARG_ENVIRONMENT} PROPERTIES ${ARG_PROPERTIES})
endfunction()

# onggi_library(NAME SOURCES ... LINKS ... PRIVATE_LINKS ...): a room of the house.
function(onggi_library NAME)
    cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
    if(ARG_SOURCES)
        add_library(${NAME} STATIC ${ARG_SOURCES})
        target_link_libraries(${NAME} PUBLIC onggi_options ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS})
    else()
        add_library(${NAME} INTERFACE)
        target_link_libraries(${NAME} INTERFACE onggi_options ${ARG_LINKS})
    endif()
endfunction()

# onggi_test(NAME SOURCES ... LINKS ... LABELS ... TIMEOUT seconds ENVIRONMENT ... SERIAL): one GoogleTest program, one
# ctest entry; SERIAL: it talks to a device or a service in real time, and wants the machine to itself. Labels: unit, paper, studio, haptics, replay, golden, device, export, stress, house, cli, install, window, tools; and
# picture for what draws with Vulkan outside golden.
function(onggi_test NAME)
    cmake_parse_arguments(ARG "SERIAL" "TIMEOUT" "SOURCES;LINKS;LABELS;ENVIRONMENT" ${ARGN})
    add_executable(${NAME} ${ARG_SOURCES})
    target_link_libraries(${NAME} PRIVATE onggi_program ${ARG_LINKS} GTest::gtest GTest::gtest_main)
    target_compile_definitions(${NAME} PRIVATE
        ONGGI_SOURCE_DIR="${CMAKE_SOURCE_DIR}" ONGGI_BINARY_DIR="${CMAKE_BINARY_DIR}")
    set_target_properties(${NAME} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
    if(NOT ARG_TIMEOUT)
        set(ARG_TIMEOUT 120)
    endif()
    add_test(NAME ${NAME} COMMAND ${NAME})
    set_tests_properties(${NAME} PROPERTIES TIMEOUT ${ARG_TIMEOUT} LABELS "${ARG_LABELS}" RUN_SERIAL ${ARG_SERIAL}
        ENVIRONMENT "LSAN_OPTIONS=suppressions=${CMAKE_SOURCE_DIR}/tests/support/lsan.supp:print_suppressions=0;${ARG_ENVIRONMENT}")
endfunction()

# onggi_vector_loops(FILE...): the loops of these are written to be worked on several elements at once. GCC takes them
# so only if it neither splits them into paths nor guards against traps that nobody has set; no result depends on either.
function(onggi_vector_loops)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS "-fno-thread-jumps;-fno-trapping-math")
    endif()
endfunction()

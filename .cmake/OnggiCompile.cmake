# Compile options of every file: language, warnings, sanitizers, and the floating-point rules that bit-exact
# replay needs.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

set(ONGGI_SANITIZE "" CACHE STRING "address,undefined | thread | fuzzer")
string(COMPARE EQUAL "${ONGGI_SANITIZE}" "fuzzer" ONGGI_FUZZ)

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
    # ccache caches files with precompiled headers only with this sloppiness; nothing here uses __TIME__.
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE_PROGRAM})
endif()

add_library(onggi_options INTERFACE)
target_include_directories(onggi_options INTERFACE ${CMAKE_SOURCE_DIR})
target_compile_definitions(onggi_options INTERFACE ONGGI_VERSION="${PROJECT_VERSION}")
target_compile_options(onggi_options INTERFACE
    -Wall -Wextra -Wpedantic -Werror
    -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast -Wnon-virtual-dtor -Woverloaded-virtual
    -Wcast-qual -Wformat=2 -Wundef -Wunused
    # One compiler compiles everything, and functions of vectors (Float8) are inlined, so that no vector crosses a boundary by
    # value.
    -Wno-psabi
    # No fused multiply-add, so that the same source gives the same bits everywhere.
    -ffp-contract=off
    # std::sqrt becomes one exact instruction; its errno is not used.
    -fno-math-errno)
# Packages must depend only on libraries that the program calls, not on those that they link in turn.
target_link_options(onggi_options INTERFACE LINKER:--as-needed)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # g++ 12 reports a false overlap in std::string's operator+ (GCC bug 105651).
    target_compile_options(onggi_options INTERFACE -Wduplicated-cond -Wlogical-op -Wno-restrict)
endif()

if(ONGGI_FUZZ)
    # Every check builds it, and its stack traces need only line numbers.
    target_compile_options(onggi_options INTERFACE -fsanitize=fuzzer-no-link,address,undefined
        -fno-sanitize-recover=all -fno-omit-frame-pointer -O1 -g1)
    target_link_options(onggi_options INTERFACE -fsanitize=address,undefined)
elseif(ONGGI_SANITIZE)
    target_compile_options(onggi_options INTERFACE -fsanitize=${ONGGI_SANITIZE} -fno-omit-frame-pointer -O1)
    target_link_options(onggi_options INTERFACE -fsanitize=${ONGGI_SANITIZE})
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        # Sanitizers cause false warnings of this kind, for example in std::regex (GCC manual,
        # -Wmaybe-uninitialized); the plain builds keep the warning.
        target_compile_options(onggi_options INTERFACE -Wno-maybe-uninitialized)
    endif()
    if(ONGGI_SANITIZE MATCHES "undefined")
        target_compile_options(onggi_options INTERFACE -fno-sanitize-recover=undefined)
    endif()
endif()

# Linked by every program, besides its own libraries.
add_library(onggi_program INTERFACE)
target_link_libraries(onggi_program INTERFACE onggi_options)
if(ONGGI_SANITIZE MATCHES "address|fuzzer")
    add_library(onggi_keep_libraries OBJECT ${CMAKE_SOURCE_DIR}/tests/support/keep_libraries.cpp)
    target_link_libraries(onggi_program INTERFACE $<TARGET_OBJECTS:onggi_keep_libraries>)
endif()

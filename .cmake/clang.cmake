# Toolchain of the presets that compile with clang: Debian 12 has clang 14, Debian 13 has clang 19.
find_program(CMAKE_CXX_COMPILER NAMES clang++-14 clang++-19 REQUIRED)

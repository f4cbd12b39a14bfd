# Writes the built commit into a header, only if it has changed: cmake -D SOURCE=checkout -D INTO=file.h -P
# commit_header.cmake
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/commit.cmake)
onggi_commit(${SOURCE})
string(TIMESTAMP day "%Y-%m-%d" UTC)
file(CONFIGURE OUTPUT ${INTO} @ONLY CONTENT "// Written while building. Any thread; constant.
#pragma once

namespace onggi::app {

inline constexpr const char* kCommit = \"@ONGGI_COMMIT@\";
inline constexpr const char* kCommitDay = \"@day@\";

}  // namespace onggi::app
")

# Puts assets/languages/*.tsv into the program: cmake -D FOLDER=... -D CODES="en ko ..." -D INTO=... -P languages.cmake
separate_arguments(CODES)
list(LENGTH CODES count)
set(text "// Written while building from assets/languages. Any thread; constant.\n#pragma once\n\n#include <array>\n#include <string_view>\n#include <utility>\n\nnamespace onggi::kiosk::built_in {\n\ninline constexpr std::array<std::pair<std::string_view, std::string_view>, ${count}> kTables{{\n")
foreach(code ${CODES})
    file(READ ${FOLDER}/${code}.tsv table)
    # A literal may hold 65536 bytes at least; these are 22000 at most.
    string(APPEND text "    {\"${code}\", R\"onggi(${table})onggi\"},\n")
endforeach()
string(APPEND text "}};\n\n}  // namespace onggi::kiosk::built_in\n")
file(WRITE ${INTO} "${text}")

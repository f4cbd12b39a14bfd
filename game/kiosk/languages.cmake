# Puts assets/languages/*.tsv into the program: cmake -D FOLDER=... -D INTO=... -P languages.cmake
set(text "// Written while building from assets/languages. Any thread; constant.\n#pragma once\n\n#include <array>\n#include <string_view>\n#include <utility>\n\nnamespace onggi::kiosk::built_in {\n\ninline constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kTables{{\n")
foreach(code en ko ar)
    file(READ ${FOLDER}/${code}.tsv table)
    # A literal may hold 65536 bytes at least; these are some 8000 each.
    string(APPEND text "    {\"${code}\", R\"onggi(${table})onggi\"},\n")
endforeach()
string(APPEND text "}};\n\n}  // namespace onggi::kiosk::built_in\n")
file(WRITE ${INTO} "${text}")

# Embeds files in the program as text: cmake -D INTO=... -D FOLDER=... -D NAMESPACE=... -D NAMES="kCss=page.css;..."
# -P embed.cmake. Compilers accept literals of at least 65536 bytes.
set(text "// Written while building from the files themselves. Any thread; constant.\n#pragma once\n\n#include <string_view>\n\nnamespace ${NAMESPACE} {\n")
foreach(pair IN LISTS NAMES)
    string(REPLACE "=" ";" pair "${pair}")
    list(GET pair 0 name)
    list(GET pair 1 file)
    file(READ ${FOLDER}/${file} content)
    string(APPEND text "\ninline constexpr std::string_view ${name} = R\"onggi(${content})onggi\";\n")
endforeach()
string(APPEND text "\n}  // namespace ${NAMESPACE}\n")
file(WRITE ${INTO} "${text}")

// Converts any bytes to valid UTF-8. Any thread.
#pragma once

#include <string>
#include <string_view>

namespace onggi::asset {

// Each byte that cannot belong to a well-formed sequence (The Unicode Standard 15.0, table 3-7: no overlong
// forms, no surrogates, nothing above U+10FFFF) becomes U+FFFD. Well-formed text is unchanged. JSON writers
// throw on invalid UTF-8, and a visitor's text must not end the program.
std::string valid_utf8(std::string_view bytes);

// The same, escaped for an element or attribute of XML 1.0; control characters become spaces.
std::string xml_text(std::string_view bytes);

}  // namespace onggi::asset

#include "game/sharing/html_text.h"

#include <fmt/format.h>

#include "engine/core/quote.h"

namespace onggi::sharing {

std::string html(std::string_view text) {
    std::string safe;
    safe.reserve(text.size() + text.size() / 8);
    while (!text.empty()) {
        std::size_t length = 1;
        switch (text.front()) {
            case '&':
                safe += "&amp;";
                break;
            case '<':
                safe += "&lt;";
                break;
            case '>':
                safe += "&gt;";
                break;
            case '"':
                safe += "&quot;";
                break;
            case '\n':
                safe += '\n';
                break;
            case '\'':
                safe += "&#39;";
                break;
            default: {
                // U+00A0 to U+00BF: no control characters, though they begin with the same byte.
                const bool is_latin = text.size() > 1 && text[0] == '\xc2' &&
                                      static_cast<unsigned char>(text[1]) >= 0xa0 &&
                                      static_cast<unsigned char>(text[1]) <= 0xbf;
                length = is_latin ? 2 : shown_character_length(text);
                safe += length > 0 ? text.substr(0, length) : std::string_view("\ufffd");
                if (length == 0) length = 1;
            }
        }
        text.remove_prefix(length);
    }
    return safe;
}

std::string language_attributes(std::string_view code, bool right_to_left) {
    return fmt::format("lang=\"{}\" dir=\"{}\"", html(code), right_to_left ? "rtl" : "ltr");
}

}  // namespace onggi::sharing

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
            case '\'':
                safe += "&#39;";
                break;
            default: {
                const bool is_no_break_space = text.starts_with("\u00a0");  // nor any other of its block
                length = is_no_break_space ? 2 : shown_character_length(text);
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

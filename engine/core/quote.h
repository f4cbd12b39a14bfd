// in_quotes: escapes foreign text for a one-line message. Any thread; allocates.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace onggi {

// Returns the length in bytes of a printable, well-formed UTF-8 character at the start of `text`; 0 if there
// is none.
inline std::size_t shown_character_length(std::string_view text) {
    if (text.empty()) return 0;
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
    if (byte(0) < 0x80) return byte(0) >= 0x20 && byte(0) != 0x7f ? 1 : 0;
    std::size_t length = 0;
    // c2 also starts the C1 control characters, below a0.
    const bool is_latin_sign = byte(0) == 0xc2 && text.size() > 1 && byte(1) >= 0xa0;
    if (is_latin_sign || (byte(0) >= 0xc3 && byte(0) <= 0xdf)) length = 2;
    if (byte(0) >= 0xe0 && byte(0) <= 0xef) length = 3;
    if (byte(0) >= 0xf0 && byte(0) <= 0xf4) length = 4;
    if (length == 0 || text.size() < length) return 0;
    for (std::size_t at = 1; at < length; ++at) {
        if ((byte(at) & 0xc0U) != 0x80) return 0;
    }
    return length;
}

// Whether a character is displayed as nothing or as a space, so that two texts that differ in it look alike:
// no-break space, soft hyphen, U+2000 to U+200F, U+2028 to U+202F, U+205F to U+206F, ideographic space, byte
// order mark.
inline bool is_invisible(std::string_view character) {
    if (character == "\xc2\xa0" || character == "\xc2\xad" || character == "\xe3\x80\x80" ||
        character == "\xef\xbb\xbf")
        return true;
    if (character.size() != 3 || character[0] != '\xe2') return false;
    const auto last = static_cast<unsigned char>(character[2]);
    if (character[1] == '\x80') return last <= 0x8f || (last >= 0xa8 && last <= 0xaf);
    return character[1] == '\x81' && last >= 0x9f && last <= 0xaf;
}

// Returns `text` between single quotes, with unprintable and invisible characters written as \xNN and cut
// after `most_bytes`, so that a binary file cannot spoil a one-line message.
inline std::string in_quotes(std::string_view text, std::size_t most_bytes = 40) {
    static constexpr std::string_view kDigits = "0123456789abcdef";
    std::string shown = "'";
    std::size_t at = 0;
    while (at < text.size() && at < most_bytes) {
        const std::size_t length = shown_character_length(text.substr(at));
        if (length > 0 && !is_invisible(text.substr(at, length))) {
            shown += text.substr(at, length);
            at += length;
            continue;
        }
        const auto byte = static_cast<unsigned char>(text[at++]);
        shown += "\\x";
        shown += kDigits[byte >> 4U];
        shown += kDigits[byte & 15U];
    }
    shown += at < text.size() ? "...'" : "'";
    return shown;
}

// The same for a file name, but complete and without quotes.
inline std::string shown_path(std::string_view path) {
    const std::string name = in_quotes(path, path.size());
    return name.substr(1, name.size() - 2);
}

}  // namespace onggi

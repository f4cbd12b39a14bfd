// Bytes as the tables write them, for tests: hex("03 01 00"). Any thread.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace onggi::testing {

// Two digits per byte; blanks and bars between them are ignored.
inline std::vector<std::uint8_t> hex(std::string_view text) {
    std::vector<std::uint8_t> bytes;
    int digits = 0;
    unsigned value = 0;
    for (const char letter : text) {
        if (letter == ' ' || letter == '|') continue;
        const auto digit = letter <= '9' ? letter - '0' : letter - 'a' + 10;
        value = value * 16 + static_cast<unsigned>(digit);
        if (++digits % 2 == 0) {
            bytes.push_back(static_cast<std::uint8_t>(value));
            value = 0;
        }
    }
    return bytes;
}

inline std::string as_hex(std::span<const std::uint8_t> bytes) {
    static constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    for (const std::uint8_t byte : bytes) {
        if (!text.empty()) text += ' ';
        text += kDigits[byte >> 4U];
        text += kDigits[byte & 15U];
    }
    return text;
}

}  // namespace onggi::testing

// Parses a text that is a number and nothing else. Any thread; no allocation, no locale.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace onggi {

// Empty for an empty text, for extra characters, and for a number out of T's range. A floating-point number
// may be infinite or NaN.
template <typename T>
[[nodiscard]] std::optional<T> number_in(std::string_view text) {
    T number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

}  // namespace onggi

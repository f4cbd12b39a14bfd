// A text that is a number and nothing else. Any thread; no allocation, no locale.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace onggi {

// None of an empty text, of one with anything beside the number, and of a number that T does not hold; a
// floating-point one may be infinite or none.
template <typename T>
[[nodiscard]] std::optional<T> number_in(std::string_view text) {
    T number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

}  // namespace onggi

// Whether a request may be acted on, from the bytes of its head alone (RFC 9112). It is asked before the HTTP
// library sees a byte, because the library repairs or ignores what the standard wants refused. Any thread;
// pure.
#pragma once

#include <cstddef>
#include <string_view>

namespace onggi::sharing {

constexpr std::size_t kMostHeadBytes = 8192;
constexpr std::size_t kMostTargetBytes = 512;  // of a target's path and query

struct RequestHead {
    enum class Kind {
        kIncomplete,  // what is there is fine so far
        kFine,
        kRefused,
    };
    Kind kind = Kind::kIncomplete;
    int status = 0;         // of a refusal: 400, 413, 414, 431, 501 or 505
    std::size_t bytes = 0;  // of a fine head, with the empty line at its end
    // Of a fine head; they point into the given bytes.
    std::string_view method{};
    std::string_view target{};
};

// Reads the first head in `bytes`, which may hold more or less than one; at most kMostHeadBytes of it. Lines
// may end with LF alone, and empty lines before the request are skipped (RFC 9112, 2.2).
[[nodiscard]] RequestHead read_head(std::string_view bytes);

// Whether the text is a host, with or without a port (RFC 9110, 7.2; RFC 3986, 3.2.2). It may be empty.
[[nodiscard]] bool is_host(std::string_view text);

namespace detail {
[[nodiscard]] bool same_word(std::string_view a, std::string_view b);  // in ASCII, whatever the case
// Without white space at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);
// Takes the text up to the sign and drops the sign; takes everything if there is no sign.
[[nodiscard]] std::string_view take_until(std::string_view& text, char sign);
[[nodiscard]] int hex_value(char letter);  // -1: no hexadecimal digit
}  // namespace detail

}  // namespace onggi::sharing

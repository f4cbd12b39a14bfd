// The code of a shared pot, its only identifier: eight letters of Crockford's base 32, 40 random bits. Any
// thread.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/result.h"

namespace onggi::sharing {

class ShareCode {
  public:
    static constexpr std::size_t kLetters = 8;

    // From the kernel's random numbers (getrandom). System lacks: it returns none.
    [[nodiscard]] static Result<ShareCode> by_chance();
    // Reads a code as typed: also small letters, O for 0, I and L for 1, with dashes, dots, spaces,
    // underscores and U+00B7 anywhere. Empty for anything else. The alphabet has no U, so that no code spells
    // a word.
    [[nodiscard]] static std::optional<ShareCode> read(std::string_view typed);
    // Reads a code exactly as in an address.
    [[nodiscard]] static std::optional<ShareCode> read_exactly(std::string_view text);

    [[nodiscard]] std::string text() const { return {letters_.data(), letters_.size()}; }  // "K73FQ9TX"
    [[nodiscard]] std::string shown() const;                                               // "K73F·Q9TX"

    friend auto operator<=>(const ShareCode&, const ShareCode&) = default;

  private:
    ShareCode() = default;
    std::array<char, kLetters> letters_{};
};

}  // namespace onggi::sharing

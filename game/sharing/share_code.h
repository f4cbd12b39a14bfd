// What a shared pot is found by, and by nothing else: eight letters of Crockford's base 32, 40 bits by
// chance. Any thread.
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

    // By the kernel's chance (getrandom). System lacks: it gives none.
    [[nodiscard]] static Result<ShareCode> by_chance();
    // What a person types: small letters too, O for 0, I and L for 1, with dashes, dots, spaces, underlines
    // and U+00B7 anywhere. None for anything else: there is no U, so that no code spells a word.
    [[nodiscard]] static std::optional<ShareCode> read(std::string_view typed);
    // As it is written in an address, to the letter.
    [[nodiscard]] static std::optional<ShareCode> read_exactly(std::string_view text);

    [[nodiscard]] std::string text() const { return {letters_.data(), letters_.size()}; }  // "K73FQ9TX"
    [[nodiscard]] std::string shown() const;                                               // "K73F·Q9TX"

    friend auto operator<=>(const ShareCode&, const ShareCode&) = default;

  private:
    ShareCode() = default;
    std::array<char, kLetters> letters_{};
};

}  // namespace onggi::sharing

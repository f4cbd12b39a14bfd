#include "game/sharing/share_code.h"

#include <sys/random.h>

#include <cerrno>
#include <cstdint>

namespace onggi::sharing {
namespace {

constexpr std::string_view kAlphabet = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";  // Crockford, 2002
constexpr std::string_view kMiddleDot = "\u00b7";

// Maps a typed letter to the alphabet; 0 if there is no match.
char meant(char letter) {
    if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
    if (letter == 'O') return '0';
    if (letter == 'I' || letter == 'L') return '1';
    return kAlphabet.find(letter) != std::string_view::npos ? letter : '\0';
}

}  // namespace

Result<ShareCode> ShareCode::by_chance() {
    std::array<std::uint8_t, kLetters> bytes{};
    std::size_t have = 0;
    while (have < bytes.size()) {
        const ssize_t got = ::getrandom(bytes.data() + have, bytes.size() - have, 0);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return system_lacks("the kernel returned no random numbers for a code");
        have += static_cast<std::size_t>(got);
    }
    ShareCode code;
    for (std::size_t i = 0; i < kLetters; ++i)
        code.letters_[i] = kAlphabet[bytes[i] % kAlphabet.size()];  // uniform: 256 is a multiple of 32
    return code;
}

std::optional<ShareCode> ShareCode::read(std::string_view typed) {
    ShareCode code;
    std::size_t have = 0;
    while (!typed.empty()) {
        if (typed.starts_with(kMiddleDot)) {
            typed.remove_prefix(kMiddleDot.size());
            continue;
        }
        const char letter = typed.front();
        typed.remove_prefix(1);
        if (letter == '-' || letter == '.' || letter == ' ' || letter == '_') continue;
        const char means = meant(letter);
        if (means == '\0' || have == kLetters) return std::nullopt;
        code.letters_[have++] = means;
    }
    if (have < kLetters) return std::nullopt;
    return code;
}

std::optional<ShareCode> ShareCode::read_exactly(std::string_view text) {
    if (text.size() != kLetters) return std::nullopt;
    ShareCode code;
    for (std::size_t i = 0; i < kLetters; ++i) {
        if (kAlphabet.find(text[i]) == std::string_view::npos) return std::nullopt;
        code.letters_[i] = text[i];
    }
    return code;
}

std::string ShareCode::shown() const {
    return text().insert(kLetters / 2, kMiddleDot);
}

}  // namespace onggi::sharing

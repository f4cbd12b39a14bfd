// Strokes as bytes, for session files; README.md gives the layout. Any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "game/decoration/stroke.h"

namespace onggi::decoration {

// What a session says of a pot's decoration.
struct Recorded {
    Strokes strokes{};
    std::uint64_t texture_hash = 0;  // of what they came to, see Texture::hash()

    friend bool operator==(const Recorded&, const Recorded&) = default;
};

[[nodiscard]] std::vector<std::byte> bytes_of(const Recorded& recorded);

// Bad input: another version, a number out of its bounds, too few or too many bytes. `name` stands for where
// they come from in the message, which names the byte.
[[nodiscard]] Result<Recorded> recorded_from(std::span<const std::byte> bytes, const std::string& name);

}  // namespace onggi::decoration

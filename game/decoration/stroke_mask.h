// How far a stroke covers each texel of a pot's wall, piece by piece: the most that any of its pieces does,
// so that in whichever portions it is laid it comes to the same. Any thread. mm; turns.
#pragma once

#include <cstdint>
#include <vector>

#include "game/decoration/texture.h"
#include "game/decoration/wall.h"

namespace onggi::decoration {

// What the hand holds: how its trace looks across.
enum class Tip { kBrush, kFinger };

// A straight piece of a stroke on the unrolled wall, with its half widths at both ends.
struct Piece {
    float turns = 0.0F;  // of its beginning, 0 to 1
    float along_mm = 0.0F;
    float half_mm = 0.0F;
    float turns_on = 0.0F;  // how much further round its end is; below half a turn
    float end_along_mm = 0.0F;
    float end_half_mm = 0.0F;
};

class StrokeMask {
  public:
    // Gives what it may have changed.
    TextureRect lay(const Piece& piece, Tip tip, const Wall& wall);
    // All texels 0 again.
    void clear();
    [[nodiscard]] std::uint8_t at(int column, int row) const {
        return covers_[static_cast<std::size_t>(row) * kColumns + static_cast<std::size_t>(column)];
    }
    [[nodiscard]] const TextureRect& extent() const { return extent_; }  // of what is not 0

  private:
    std::vector<std::uint8_t> covers_ = std::vector<std::uint8_t>(std::size_t{kColumns} * kRows);
    TextureRect extent_;
};

}  // namespace onggi::decoration

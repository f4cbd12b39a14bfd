// A stroke's cover of each texel of a pot's wall: the maximum over its pieces, so that the result does not
// depend on how the stroke is split into pieces. Any thread. mm; turns.
#pragma once

#include <cstdint>
#include <vector>

#include "game/decoration/texture.h"
#include "game/decoration/wall.h"

namespace onggi::decoration {

// The tool's tip, which sets the profile across its trace.
enum class Tip { kBrush, kFinger };

// A straight piece of a stroke on the unrolled wall, with its half widths at both ends.
struct Piece {
    float turns = 0.0F;  // of its start, 0 to 1
    float along_mm = 0.0F;
    float half_mm = 0.0F;
    float turns_on = 0.0F;  // signed angle from start to end; below half a turn
    float end_along_mm = 0.0F;
    float end_half_mm = 0.0F;
};

class StrokeMask {
  public:
    // Returns the part that may have changed.
    TextureRect lay(const Piece& piece, Tip tip, const Wall& wall);
    // Sets all texels to 0.
    void clear();
    [[nodiscard]] std::uint8_t at(int column, int row) const {
        return covers_[static_cast<std::size_t>(row) * kColumns + static_cast<std::size_t>(column)];
    }
    [[nodiscard]] const TextureRect& extent() const { return extent_; }  // the part that may be non-zero

  private:
    std::vector<std::uint8_t> covers_ = std::vector<std::uint8_t>(std::size_t{kColumns} * kRows);
    TextureRect extent_;
};

}  // namespace onggi::decoration

// A pot's section as a line, as in a museum's drawing of a vessel: the data for a small picture. Any thread;
// plain data. mm.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/math/math.h"
#include "game/decoration/canvas.h"

namespace onggi::pot {

// Up the outside from the foot, over the rim, down the inside to the axis. Without an inside it is a solid
// lump.
struct Section {
    std::vector<vec2> outside;  // (radius, height), heights rising
    std::vector<vec2> inside;   // (radius, height), rim first, heights falling; may be empty
    std::shared_ptr<const decoration::Marks> marks{};  // drawn on the outside; null without marks

    [[nodiscard]] float height_mm() const;
    [[nodiscard]] float radius_mm() const;  // the largest
    [[nodiscard]] std::uint64_t hash() const;
};

// Adds an inside with a wall of this thickness to an outline whose outside alone is known.
[[nodiscard]] Section hollowed(std::vector<vec2> outside, float wall_mm, float floor_mm);

// A fresh lump of one kilogram: about as wide as it is high.
[[nodiscard]] const Section& fresh_lump();

}  // namespace onggi::pot

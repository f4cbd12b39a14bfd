// A pot's section as a line, as in a museum's drawing of a vessel: the data for a small picture. Any thread;
// plain data. mm.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/math/math.h"
#include "game/clay/studio/rings.h"
#include "game/decoration/canvas.h"

namespace onggi::pot {

// How far a pot is from round: rows evenly spaced over its height, the first at the foot, the last at the
// rim. `part` is a height as a part of the pot's.
struct OffRound {
    std::vector<vec2> centre_mm{};  // of each row: along the clay's +X, and a quarter turn counter-clockwise
    // Rows of kCorners, evenly spaced, counter-clockwise in the clay's frame, the first in direction +X;
    // added to both faces. Empty: each row is round about its centre.
    std::vector<float> dents_mm{};
    static constexpr int kCorners = 128;

    [[nodiscard]] vec2 centre_at(float part) const;
    [[nodiscard]] float dent_at(float part, float turns) const;  // in a direction in turns from +X
};

// Up the outside from the foot, over the rim, down the inside to the axis. Without an inside it is a solid
// lump.
struct Section {
    std::vector<vec2> outside;  // (radius, height), heights rising
    std::vector<vec2> inside;   // (radius, height), rim first, heights falling; may be empty
    std::shared_ptr<const decoration::Marks> marks{};  // drawn on the outside; null without marks
    std::shared_ptr<const OffRound> off_round{};       // null: round

    [[nodiscard]] float height_mm() const;
    [[nodiscard]] float radius_mm() const;  // the largest distance of the outside from the axis
    // The clay's direction that faces the eye in pictures, in turns from +X: the decoration's front.
    [[nodiscard]] float front_turns() const;
    [[nodiscard]] std::uint64_t hash() const;
};

// All lengths times `scale`. Null where it would not be seen: no row is off by more than a quarter of a
// millimetre.
[[nodiscard]] std::shared_ptr<const OffRound> off_round_of(const clay::studio::Rings& rings, double scale);

// Adds an inside with a wall of this thickness to an outline whose outside alone is known.
[[nodiscard]] Section hollowed(std::vector<vec2> outside, float wall_mm, float floor_mm);

// A fresh lump of one kilogram: about as wide as it is high.
[[nodiscard]] const Section& fresh_lump();

}  // namespace onggi::pot

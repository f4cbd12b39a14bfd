// Walls and strokes to try decorations on.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include "game/decoration/canvas.h"

namespace onggi::decoration {

// A jar of 160 mm, 60 mm in radius where it is widest.
inline Wall sample_wall() {
    std::vector<vec2> outline;
    for (int i = 0; i <= 40; ++i) {
        const float y = 4.0F * static_cast<float>(i);
        const float off = (y - 90.0F) / 90.0F;
        outline.push_back({60.0F - 28.0F * off * off, y});
    }
    return wall_of(outline);
}

inline StrokePoint point(double turns, double height_mm, double pressure = 1.0) {
    return stroke_point(turns, height_mm, pressure).value();
}

// A random stroke of any kind.
inline Stroke random_stroke(std::mt19937& random) {
    const auto number = [&](int least, int most) {
        return least + static_cast<int>(random() % static_cast<unsigned>(most - least + 1));
    };
    Stroke stroke;
    stroke.technique = static_cast<Technique>(number(1, number(0, 9) == 0 ? 7 : 6));
    if (stroke.technique == Technique::kClear) return stroke;
    stroke.slip = static_cast<Slip>(number(0, 1));
    double turns = number(0, 999) / 1000.0;
    double height = number(0, 160);
    if (stroke.technique == Technique::kMotif) {
        stroke.motif = static_cast<Motif>(number(1, kMotifCount - 1));
        stroke.repeats = static_cast<std::uint8_t>(number(1, 6));
        stroke.width = static_cast<std::uint16_t>(number(1500, 6000));
        stroke.points = {point(turns, height)};
        return stroke;
    }
    stroke.width = static_cast<std::uint16_t>(number(100, 2600));
    const int count = number(1, 12);
    for (int i = 0; i < count; ++i) {
        stroke.points.push_back(point(turns, height, number(0, 255) / 255.0));
        turns += number(-60, 60) / 1000.0;
        height = std::min(160.0, std::max(0.0, height + number(-20, 20)));
    }
    return stroke;
}

}  // namespace onggi::decoration

// The forces of a touch, made visible: an arrow for each where the hand touches the clay, the rings it
// touches lit, and how force and tick rate went lately. Drawn anew every frame. Main thread. Pixels, N.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "engine/ui/draw_list.h"
#include "game/screens/force_trace.h"
#include "game/screens/page/composition.h"

namespace onggi::screens {

struct ForceArrow {
    vec2 from_px{0.0F};
    vec2 to_px{0.0F};
    // How much of its length is seen; little: it points into the picture, or out of it.
    float seen = 1.0F;
    bool towards = false;  // out of it
    bool shown = false;    // there is such a force
};

// Where one hand touches.
struct ForceTouch {
    std::array<ForceArrow, kForceCount> arrows{};
    std::vector<std::vector<vec2>> rings_px{};  // a line for each that is lit, or for some of many
    // The stretch of clay they fill; empty: seen through its mouth.
    std::vector<vec2> upper_px{};
    std::vector<vec2> lower_px{};
};

struct ForceFrame {
    std::vector<ForceTouch> touches{};  // the first has names at its arrows
    std::array<double, kForceCount> size_n{};
    const ForceTrace* trace = nullptr;
    bool with_sum = true;  // else the three alone, as a lesson
};

// What drawing needs of its surroundings.
struct ForcePainter {
    ui::DrawList& list;
    float px_per_u = 1.0F;
    ui::Rect bounds_px;
    std::function<std::optional<ui::Rect>(const Item&)> place;  // in the atlas
};

// The line and head of one force; they differ in form too, so that colour is never the only sign.
void draw_arrow(ui::DrawList& list, Force force, vec2 from_px, vec2 to_px, float px_per_u);
void draw_touches(const ForceFrame& frame, const ForceParts& parts, const ForcePainter& painter);
// What changes in the panel: its numbers and plots.
void draw_force_panel(const ForceFrame& frame, const ForceParts& parts, const ForcePainter& painter);

// Boxes side by side on a screen: each moved as little as possible so that none covers another. Those that
// cannot be kept apart on the screen stay on it.
void keep_apart(std::span<ui::Rect> boxes, const ui::Rect& bounds, float gap);

}  // namespace onggi::screens

// How thick a wall is that has been cut open, in numbers beside its section: where they are taken, and what
// goes over the picture. Any thread, a painter being one thread's at a time. mm; pixels from the top left.
#pragma once

#include <string>
#include <vector>

#include "engine/asset/image.h"
#include "engine/render/camera.h"
#include "engine/ui/painter.h"
#include "game/pot/pot.h"

namespace onggi::wheel {

// One thickness: of the wall level through it, of the floor upright at half its radius.
struct SectionMeasure {
    bool of_floor = false;
    double height_mm = 0.0;  // of the ring that was measured, at its middle; of the floor, half of it
    double thickness_mm = 0.0;
    double outer_mm = 0.0;  // radius of the outer face there
};

// Of a hollow pot: its floor, and its wall below the rim, above the floor, where it is thinnest, widest and
// narrowest, and where that leaves a long way between; top down, the floor last. Of a solid one: nothing.
[[nodiscard]] std::vector<SectionMeasure> section_measures(const pot::Pot& pot);

// As they are written: "6.4 mm".
[[nodiscard]] std::string words_of(const SectionMeasure& measure);

// The measures as tags, as the wheel stands (WheelView), beside the section that faces this camera, each with
// a line to where it was taken; walls to the right, the floor to the left, no tag over another. Empty where
// the pot is solid or the picture too small to read them.
[[nodiscard]] ui::Sketch section_labels(const pot::Pot& pot, const dvec2& wheel_direction,
                                        const render::Camera& camera, int width_px, int height_px,
                                        ui::Painter& painter);

// Lays a painting of the picture's size over it.
void lay_over(asset::Image& picture, const ui::Painting& painting);

}  // namespace onggi::wheel

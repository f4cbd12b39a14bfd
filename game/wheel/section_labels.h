// Thickness labels beside the section of a pot that is cut open: where walls are measured, and the overlay.
// Any thread, but a painter belongs to one thread at a time. mm; pixels from the top left.
#pragma once

#include <string>
#include <vector>

#include "engine/asset/image.h"
#include "engine/render/camera.h"
#include "engine/ui/painter.h"
#include "game/pot/pot.h"

namespace onggi::wheel {

// One thickness: a wall's is measured horizontally, the floor's vertically at half its radius.
struct SectionMeasure {
    bool of_floor = false;
    double height_mm = 0.0;  // middle of the measured ring; half the thickness of the floor
    double thickness_mm = 0.0;
    double outer_mm = 0.0;  // radius of the outer face there
};

// For a hollow pot: its wall below the rim, above the floor, at its thinnest, widest and narrowest place, and
// in long gaps between those, top down; the floor last. Empty for a solid pot.
[[nodiscard]] std::vector<SectionMeasure> section_measures(const pot::Pot& pot);

// The measure as text: "6.4 mm".
[[nodiscard]] std::string words_of(const SectionMeasure& measure);

// The measures as tags beside the section that faces this camera, at the wheel's angle (cos, sin), each
// with a line to its wall; walls to the right, the floor to the left, without overlap. Empty if the pot is
// solid or the picture too small to read them.
[[nodiscard]] ui::Sketch section_labels(const pot::Pot& pot, const dvec2& wheel_direction,
                                        const render::Camera& camera, int width_px, int height_px,
                                        ui::Painter& painter);

// Composites a painting of the same size over the picture.
void lay_over(asset::Image& picture, const ui::Painting& painting);

}  // namespace onggi::wheel

// Which rows of vertices a lathe is drawn with, and what is the same all the way round each. Any thread; pure
// functions. mm, pixels.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/render/camera.h"
#include "engine/render/shapes/lathe_light.h"
#include "engine/render/shapes/lathe_profile.h"
#include "engine/render/shapes/ring_lod.h"
#include "shaders/frame_data.h"

namespace onggi::render {

struct RowBudget {
    float tolerance_mm = 0.05F;  // wanted: no ring lies further from the drawn outline than this
    int max_rows = 128;          // hard, everything counted
    int edge_stride = 3;         // of the rounded edge's points
    float max_span_mm = 9.0F;    // between two rows of a wall, so that light interpolates over short spans
};

struct LatheRows {
    std::vector<std::uint32_t> points;  // of the profile, in its order
    std::size_t inside = 0;             // rows from here on are on the inner face, or the top of a solid
    float tolerance_mm = 0.0F;          // the one that met the cap
};

// How much of the inside an eye can see: the number of the profile's points, from its first, that must be
// drawn. All of them if the floor shows; none of the inside if the eye lies below the rim.
// slack_mm: how far dents and a pot off its centre may move what hides.
[[nodiscard]] std::size_t points_seen(const LatheProfile& profile, vec3 eye_mm, float slack_mm);

[[nodiscard]] LatheRows choose_rows(const LatheProfile& profile, std::size_t seen, const RowBudget& budget);

// What light and water make of each row. `rows` is used again.
void fill_rows(const Lathe& lathe, const LatheProfile& profile, const LatheSamples& samples,
               const LatheRows& chosen, std::vector<shaders::RowData>& rows);

}  // namespace onggi::render

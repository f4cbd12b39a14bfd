#include "engine/render/outline_strips.h"

#include <algorithm>
#include <cmath>

namespace onggi::render {

void make_strips(std::span<const OutlinePiece> pieces, vec2 picture_px, std::vector<StripCorner>& corners) {
    corners.clear();
    corners.reserve(kStripCorners * pieces.size());
    for (const OutlinePiece& piece : pieces) {
        const vec2 from(piece.from);
        const vec2 to(piece.to);
        const vec2 along = to - from;
        const vec2 length = glm::abs(along);
        const bool is_level = length.x > length.y;
        // A quarter of a pixel further at both ends, so that pieces that turn a corner leave no pixel out.
        const vec2 beyond = along / std::max({length.x, length.y, 1e-4F}) * 0.25F;
        const vec4 line(from, is_level ? along.y / along.x : along.x / along.y, is_level ? 1.0F : 0.0F);
        for (const float side_px : {-0.52F, 0.52F}) {
            const vec2 side = is_level ? vec2(0.0F, side_px) : vec2(side_px, 0.0F);
            const auto add = [&](vec2 at_px, float depth) {
                corners.push_back(
                    {.at = vec3((at_px + side) / picture_px * 2.0F - 1.0F, depth), .line = line});
            };
            add(from - beyond, piece.from.z);
            add(to + beyond, piece.to.z);
        }
    }
}

}  // namespace onggi::render

#include "game/pot/section.h"

#include <algorithm>
#include <utility>

#include "engine/core/hash.h"

namespace onggi::pot {

float Section::height_mm() const {
    float highest = 0.0F;
    for (const vec2& point : outside)
        highest = std::max(highest, point.y);
    return highest;
}

float Section::radius_mm() const {
    float widest = 0.0F;
    for (const vec2& point : outside)
        widest = std::max(widest, point.x);
    return widest;
}

std::uint64_t Section::hash() const {
    StateHash hash;
    for (const std::vector<vec2>* side : {&outside, &inside}) {
        hash.add_word(side->size());
        for (const vec2& point : *side)
            hash.add(double{point.x}), hash.add(double{point.y});
    }
    if (marks) {
        hash.add_word(marks->recorded.texture_hash);
        hash.add_bytes(decoration::bytes_of(marks->recorded));
    }
    return hash.value();
}

Section hollowed(std::vector<vec2> outside, float wall_mm, float floor_mm) {
    Section shape{.outside = std::move(outside), .inside = {}};
    for (auto point = shape.outside.rbegin(); point != shape.outside.rend(); ++point) {
        const float radius = point->x - wall_mm;
        if (point->y < floor_mm || radius <= 0.0F) break;
        shape.inside.push_back({radius, point->y});
    }
    if (shape.inside.empty()) return shape;
    shape.inside.push_back({0.6F * shape.inside.back().x, floor_mm});
    shape.inside.push_back({0.0F, floor_mm});
    return shape;
}

const Section& fresh_lump() {
    static const Section shape{.outside = {{62.0F, 0.0F},
                                           {67.0F, 8.0F},
                                           {68.0F, 24.0F},
                                           {66.0F, 42.0F},
                                           {60.0F, 62.0F},
                                           {50.0F, 80.0F},
                                           {34.0F, 92.0F},
                                           {16.0F, 98.0F},
                                           {0.5F, 99.0F}},
                               .inside = {}};
    return shape;
}

}  // namespace onggi::pot

#include "game/pot/section.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/core/hash.h"
#include "game/pot/surface_builder.h"

namespace onggi::pot {

namespace {

constexpr int kDentRows = 64;
// An axis may jump by millimetres from one ring to the next.
constexpr int kCentreRows = 256;
constexpr float kSeenMm = 0.25F;
constexpr double kPerMm = 100.0;  // the steps that files keep

// Neighbouring rows of a height, and the upper one's share.
struct Between {
    std::size_t low = 0;
    std::size_t high = 0;
    float up = 0.0F;
};
Between rows_at(float part, std::size_t count) {
    const float row = std::clamp(part, 0.0F, 1.0F) * static_cast<float>(count - 1);
    const auto low = static_cast<std::size_t>(row);
    return {low, std::min(low + 1, count - 1), row - static_cast<float>(low)};
}

}  // namespace

vec2 OffRound::centre_at(float part) const {
    const Between rows = rows_at(part, centre_mm.size());
    return glm::mix(centre_mm[rows.low], centre_mm[rows.high], rows.up);
}

float OffRound::dent_at(float part, float turns) const {
    if (dents_mm.empty()) return 0.0F;
    const Between rows = rows_at(part, dents_mm.size() / kCorners);
    const float corner = (turns - std::floor(turns)) * kCorners;
    const auto first = static_cast<std::size_t>(corner);
    const auto in_row = [&](std::size_t row) {
        const float* const dents = dents_mm.data() + row * kCorners;
        return glm::mix(dents[first % kCorners], dents[(first + 1) % kCorners],
                        corner - static_cast<float>(first));
    };
    return glm::mix(in_row(rows.low), in_row(rows.high), rows.up);
}

namespace {

// Between the middles of rings, as in the solid.
dvec2 centre_at(const clay::studio::Rings& rings, double height_mm) {
    const auto centre_of = [&](int ring) {
        const std::size_t at = clay::studio::Rings::at(ring);
        return dvec2(double{rings.centre_x_mm[at]}, double{rings.centre_z_mm[at]});
    };
    int low = rings.ring_at(height_mm);
    if (low > 0 && rings.centre_mm(low) > height_mm) --low;
    const int high = std::min(low + 1, rings.count - 1);
    const double from_mm = rings.centre_mm(low);
    const double between_mm = std::max(rings.centre_mm(high) - from_mm, 1e-6);
    return glm::mix(centre_of(low), centre_of(high),
                    std::clamp((height_mm - from_mm) / between_mm, 0.0, 1.0));
}

}  // namespace

std::shared_ptr<const OffRound> off_round_of(const clay::studio::Rings& rings, double scale) {
    const auto in_steps = [&](double mm) {
        return static_cast<float>(std::round(mm * scale * kPerMm) / kPerMm);
    };
    if (rings.count == 0) return nullptr;
    OffRound map;
    float most_mm = 0.0F;
    for (int row = 0; row < kCentreRows; ++row) {
        const dvec2 centre = centre_at(rings, rings.top_mm() * row / (kCentreRows - 1));
        map.centre_mm.emplace_back(in_steps(centre.x), in_steps(centre.y));
        most_mm = std::max(most_mm, glm::length(map.centre_mm.back()));
    }
    float most_dent_mm = 0.0F;
    for (int row = 0; row < kDentRows; ++row) {
        const int ring =
            rings.ring_at(std::min(rings.top_mm() * row / (kDentRows - 1), rings.centre_mm(rings.count - 1)));
        std::vector<double> dents(OffRound::kCorners, 0.0);
        if (rings.rough_mm[clay::studio::Rings::at(ring)] > 0.0F)
            dents = dents_at_corners({rings.row_of(ring), clay::studio::Rings::at(rings.sectors)},
                                     OffRound::kCorners);
        for (const double dent_mm : dents) {
            map.dents_mm.push_back(in_steps(dent_mm));
            most_dent_mm = std::max(most_dent_mm, std::abs(map.dents_mm.back()));
        }
    }
    if (most_dent_mm < kSeenMm) map.dents_mm.clear();
    if (std::max(most_mm, most_dent_mm) < kSeenMm) return nullptr;
    return std::make_shared<const OffRound>(std::move(map));
}

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
    if (!off_round) return widest;
    const float height = std::max(height_mm(), 1e-3F);
    widest = 0.0F;
    for (const vec2& point : outside) {
        const vec2 centre = off_round->centre_at(point.y / height);
        for (int corner = 0; corner < OffRound::kCorners; ++corner) {
            const float turns = static_cast<float>(corner) / OffRound::kCorners;
            const float radius = point.x + off_round->dent_at(point.y / height, turns);
            const vec2 way(std::cos(kTurnF * turns), std::sin(kTurnF * turns));
            widest = std::max(widest, glm::length(centre + radius * way));
        }
    }
    return widest;
}

float Section::front_turns() const {
    return marks ? decoration::front_of(marks->recorded.strokes) : decoration::kPlainFront;
}

std::uint64_t Section::hash() const {
    StateHash hash;
    for (const std::vector<vec2>* side : {&outside, &inside}) {
        hash.add_word(side->size());
        for (const vec2& point : *side)
            hash.add(double{point.x}), hash.add(double{point.y});
    }
    if (off_round) {
        for (const vec2& centre : off_round->centre_mm)
            hash.add(double{centre.x}), hash.add(double{centre.y});
        for (const float dent_mm : off_round->dents_mm)
            hash.add(double{dent_mm});
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

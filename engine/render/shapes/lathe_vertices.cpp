#include "engine/render/shapes/lathe_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace onggi::render {
namespace {

// Values of a sector's edge that are the same in every row.
struct SectorEdge {
    vec2 outward;         // (x, z)
    std::size_t dent;     // index of the dents' sector below it
    float dent_fraction;  // weight of the next sector
    std::size_t column;   // likewise, of the key light's columns
    float column_fraction;
    float fraction;  // of a turn from +X, or of the way from one side of a cut to the other
    float
        // An inscribed polygon looks thinner than its circle: half of the sag lies outside, half inside.
        straddle;
};

std::vector<SectorEdge> sector_edges(const Lathe& lathe, const DirectionalLight& key,
                                     std::span<const float> angles_rad) {
    const float turned = std::atan2(lathe.turn.y, lathe.turn.x);
    const float light = std::atan2(key.towards_light.z, key.towards_light.x);
    std::vector<SectorEdge> edges;
    edges.reserve(angles_rad.size());
    const std::size_t last = angles_rad.size() - 1;
    const float sweep = angles_rad[last] - angles_rad[0];
    for (std::size_t i = 0; i <= last; ++i) {
        SectorEdge edge{};
        // The last edge of a whole turn equals the first bit by bit.
        const float shown = angles_rad[!lathe.cut && i == last ? 0 : i];
        // The streaks' coordinate is fixed to the lathe, independent of the eye.
        edge.fraction = lathe.cut ? (angles_rad[i] - angles_rad[0]) / sweep : angles_rad[i] / kTurnF;
        const std::size_t from = i > 0 ? i - 1 : 0;
        const float chord = (angles_rad[std::min(i + 1, last)] - angles_rad[from]) /
                            static_cast<float>(std::min(i + 1, last) - from);
        edge.straddle = 1.0F + 0.5F * (1.0F - std::cos(0.5F * chord));
        edge.outward = {std::cos(shown), std::sin(shown)};
        float own = (-shown - turned) / kTurnF;
        // A sector's value applies at its middle.
        own = (own - std::floor(own)) * kDentSectors + kDentSectors - 0.5F;
        edge.dent = static_cast<std::size_t>(own) % kDentSectors;
        edge.dent_fraction = own - std::floor(own);
        float away = std::abs(shown - light);
        away = std::fmod(away, kTurnF);
        if (away > kPiF) away = kTurnF - away;
        const float column = away / kPiF * (kKeyColumns - 1);
        edge.column = std::min(static_cast<std::size_t>(column), static_cast<std::size_t>(kKeyColumns - 2));
        edge.column_fraction = column - static_cast<float>(edge.column);
        edges.push_back(edge);
    }
    return edges;
}

// Dents at one height, and their derivatives.
struct DentRow {
    std::array<float, kDentSectors> off_mm{};
    std::array<float, kDentSectors> rise{};   // per mm of height
    std::array<float, kDentSectors> round{};  // per sector
};

bool dents_at(const Lathe& lathe, float y_mm, float height_mm, DentRow& row) {
    const std::size_t count = lathe.dents_mm.size() / kDentSectors;
    if (count == 0 || height_mm <= 0.0F) return false;
    const float step_mm = height_mm / static_cast<float>(count);
    const float place = std::clamp(y_mm / step_mm - 0.5F, 0.0F, static_cast<float>(count - 1));
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, count - 1);
    const float fraction = place - static_cast<float>(below);
    const std::span<const float> low = lathe.dents_mm.subspan(below * kDentSectors, kDentSectors);
    const std::span<const float> high = lathe.dents_mm.subspan(above * kDentSectors, kDentSectors);
    for (std::size_t s = 0; s < kDentSectors; ++s) {
        row.off_mm[s] = low[s] + fraction * (high[s] - low[s]);
        row.rise[s] = above > below ? (high[s] - low[s]) / step_mm : 0.0F;
    }
    // Slopes at the sectors' middles, so that they vary linearly between them and no facet shows.
    for (std::size_t s = 0; s < kDentSectors; ++s)
        row.round[s] =
            0.5F * (row.off_mm[(s + 1) % kDentSectors] - row.off_mm[(s + kDentSectors - 1) % kDentSectors]);
    return true;
}

vec2 centre_at(std::span<const vec2> centres, float ring) {
    const float place = std::clamp(ring, 0.0F, static_cast<float>(centres.size() - 1));
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, centres.size() - 1);
    return centres[below] + (place - static_cast<float>(below)) * (centres[above] - centres[below]);
}

}  // namespace

float largest_offset_mm(const Lathe& lathe) {
    float largest = 0.0F;
    for (const float dent : lathe.dents_mm)
        largest = std::max(largest, std::abs(dent));
    float furthest = 0.0F;
    for (const vec2& centre : lathe.centre_mm)
        furthest = std::max(furthest, glm::length(centre));
    return largest + furthest;
}

void fill_vertices(const LatheMeshInput& input, const DirectionalLight& key,
                   std::span<const float> angles_rad, std::vector<shaders::VertexData>& vertices) {
    const Lathe& lathe = input.lathe;
    const std::vector<SectorEdge> edges = sector_edges(lathe, key, angles_rad);
    const KeyRay ray{.towards_light = key.towards_light, .tangent = std::tan(key.angular_radius_rad)};
    const bool off_centre = lathe.centre_mm.size() == lathe.radii_mm.size();
    vertices.clear();
    vertices.reserve(input.rows.size() * edges.size());
    DentRow dents;
    KeyColumns seen{};
    vec2 centre_before(0.0F);
    for (std::size_t row = 0; row < input.rows.size(); ++row) {
        const vec4& place = input.rows[row].place;
        const vec4& light = input.rows[row].light;
        const std::size_t point = input.chosen.points[row];
        const bool is_inside = input.profile.hollow && row >= input.chosen.inside;
        const bool is_edge = point >= input.profile.edge && point < input.profile.inside;
        // Nothing shades the rounded edge or a solid's top. The inside of a cut pot is lit from the front.
        if (is_edge || (row >= input.chosen.inside && (!input.profile.hollow || lathe.cut))) {
            seen.fill(1.0F);
        } else {
            key_columns(input.samples, is_inside ? LatheFace::kInner : LatheFace::kOuter,
                        vec2(place.x, place.y), vec2(light.x, light.y), ray, seen);
        }
        const bool dented = dents_at(lathe, place.y, input.profile.height_mm, dents);
        vec2 centre(0.0F);
        vec2 drift(0.0F);  // of the centre, per mm of height
        if (off_centre) {
            const vec2 own = centre_at(lathe.centre_mm, input.profile.points[point].ring);
            centre = {own.x * lathe.turn.x + own.y * lathe.turn.y,
                      own.y * lathe.turn.x - own.x * lathe.turn.y};
            const float rise = row > 0 ? place.y - input.rows[row - 1].place.y : 0.0F;
            if (std::abs(rise) > 0.2F) drift = (centre - centre_before) / rise;
            centre_before = centre;
        }
        for (const SectorEdge& edge : edges) {
            const float radius = place.x * edge.straddle;
            float off_mm = 0.0F;
            float lean = glm::dot(drift, edge.outward);
            vec2 outward = edge.outward;
            if (dented && place.x > 0.0F) {
                const std::size_t next = (edge.dent + 1) % kDentSectors;
                off_mm = dents.off_mm[edge.dent] +
                         edge.dent_fraction * (dents.off_mm[next] - dents.off_mm[edge.dent]);
                // At the corner the floor moves with the wall, at the axis not at all.
                if (point >= input.profile.floor)
                    off_mm *= place.x / input.profile.points[input.profile.floor - 1].radius_mm;
                lean +=
                    dents.rise[edge.dent] + edge.dent_fraction * (dents.rise[next] - dents.rise[edge.dent]);
                // Sectors run against the angle, so their slope changes sign.
                const float round = dents.round[edge.dent] +
                                    edge.dent_fraction * (dents.round[next] - dents.round[edge.dent]);
                const float slope = -round * kDentSectors / (kTurnF * std::max(radius + off_mm, 1.0F));
                outward -= slope * vec2(-edge.outward.y, edge.outward.x);
                outward /= glm::length(outward);
            }
            const float r = std::max(radius + off_mm, 0.0F);
            vertices.push_back(
                {.place = vec4(
                     centre.x + r * edge.outward.x, place.y, centre.y + r * edge.outward.y,
                     seen[edge.column] + edge.column_fraction * (seen[edge.column + 1] - seen[edge.column])),
                 .lean = vec4(outward.x, lean, outward.y, edge.fraction)});
        }
    }
}

}  // namespace onggi::render

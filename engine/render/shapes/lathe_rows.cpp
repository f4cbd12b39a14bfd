#include "engine/render/shapes/lathe_rows.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace onggi::render {
namespace {

// A ring's value of a column that may not be there, between rings by their fraction.
float column_at(std::span<const float> column, float ring, float without) {
    if (column.empty()) return without;
    const float last = static_cast<float>(column.size() - 1);
    const float place = std::clamp(ring, 0.0F, last);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, column.size() - 1);
    return column[below] + (place - static_cast<float>(below)) * (column[above] - column[below]);
}

// Whether a point inside, across the axis from the eye (x < 0) or on its near side, is in sight: in the
// upright plane through eye and axis, no ring above it may cut the line of sight.
class Sight {
  public:
    Sight(const LatheProfile& profile, vec3 eye_mm, float slack_mm)
        : eye_(std::hypot(eye_mm.x, eye_mm.z), eye_mm.y) {
        const std::size_t count = profile.floor - profile.inside;
        const std::size_t stride = std::max<std::size_t>(count / kLevels, 1);
        // The highest of the edge, where the wall is thinnest, then down.
        for (std::size_t i = profile.inside; i < profile.floor; i += stride)
            rings_.emplace_back(profile.points[i].radius_mm + slack_mm, profile.points[i].y_mm);
        rim_mm_ = profile.height_mm;
    }
    [[nodiscard]] bool reaches(vec2 point) const {
        if (eye_.y <= rim_mm_) return false;
        for (const vec2& ring : rings_) {
            if (ring.y <= point.y) break;
            const float fraction = (ring.y - point.y) / (eye_.y - point.y);
            if (std::abs(point.x + fraction * (eye_.x - point.x)) > ring.x) return false;
        }
        return true;
    }

  private:
    static constexpr std::size_t kLevels = 40;
    vec2 eye_;
    std::vector<vec2> rings_;  // (r, y), from the top
    float rim_mm_ = 0.0F;
};

}  // namespace

std::size_t points_seen(const LatheProfile& profile, vec3 eye_mm, float slack_mm) {
    if (!profile.hollow) return profile.points.size();
    const Sight sight(profile, eye_mm, slack_mm);
    const ProfilePoint& corner = profile.points[profile.floor - 1];
    for (const float fraction : {-0.98F, -0.6F, -0.2F, 0.2F, 0.6F, 0.98F}) {
        if (sight.reaches({fraction * corner.radius_mm, corner.y_mm})) return profile.points.size();
    }
    // From the floor up, to the deepest of the far wall that shows.
    std::size_t end = profile.floor;
    while (end > profile.inside) {
        const ProfilePoint& point = profile.points[end - 1];
        if (sight.reaches({-point.radius_mm, point.y_mm})) break;
        --end;
    }
    // A margin, because only forty levels of what hides were looked at.
    const float lower_mm = end > profile.inside ? profile.points[end - 1].y_mm - 3.0F - slack_mm : 0.0F;
    while (end > profile.inside && end < profile.floor && profile.points[end].y_mm > lower_mm)
        ++end;
    return std::max(end, profile.inside);
}

LatheRows choose_rows(const LatheProfile& profile, std::size_t seen, const RowBudget& budget) {
    LatheRows chosen;
    if (profile.empty()) return chosen;
    std::vector<std::uint32_t> edge;
    const auto stride = static_cast<std::size_t>(std::max(budget.edge_stride, 1));
    for (std::size_t i = profile.edge + stride - 1; i < profile.inside; i += stride)
        edge.push_back(static_cast<std::uint32_t>(i));
    const std::size_t floor = seen > profile.floor ? profile.points.size() - profile.floor : 0;
    const std::size_t inner_end = std::min(seen, profile.floor);

    // Both walls by height, rising.
    std::array<std::vector<float>, 2> radii;
    std::array<std::vector<float>, 2> places;
    for (std::size_t i = 0; i < profile.edge; ++i) {
        radii[0].push_back(profile.points[i].radius_mm);
        places[0].push_back(profile.points[i].y_mm);
    }
    for (std::size_t i = inner_end; i-- > profile.inside;) {
        radii[1].push_back(profile.points[i].radius_mm);
        places[1].push_back(profile.points[i].y_mm);
    }
    const std::array faces{LodFace{radii[0], places[0]}, LodFace{radii[1], places[1]}};
    const int room = budget.max_rows - static_cast<int>(edge.size() + floor);
    const std::vector<RingChoice> walls =
        choose_face_rings(std::span(faces).first(radii[1].empty() ? 1 : 2),
                          {.tolerance_mm = budget.tolerance_mm,
                           .max_rings = room,
                           .max_step = static_cast<int>(profile.points.size()),
                           .max_span_mm = budget.max_span_mm});
    chosen.tolerance_mm = walls.front().tolerance_mm;
    chosen.points = walls.front().elements;
    chosen.points.insert(chosen.points.end(), edge.begin(), edge.end());
    chosen.inside = chosen.points.size();
    if (walls.size() > 1) {
        const std::vector<std::uint32_t>& elements = walls[1].elements;
        for (auto element = elements.rbegin(); element != elements.rend(); ++element)
            chosen.points.push_back(static_cast<std::uint32_t>(inner_end) - 1 - *element);
    }
    for (std::size_t i = 0; i < floor; ++i)
        chosen.points.push_back(static_cast<std::uint32_t>(profile.floor + i));
    return chosen;
}

void fill_rows(const Lathe& lathe, const LatheProfile& profile, const LatheSamples& samples,
               const LatheRows& chosen, std::vector<shaders::RowData>& rows) {
    constexpr float kNormalSpanMm = 3.0F;  // of what lights a whole row: wider than a groove
    constexpr float kOpenEveryMm = 9.0F;   // rays are walked that often, and interpolated between
    rows.clear();
    float open = 1.0F;
    float open_at_mm = -1e9F;
    std::size_t open_row = 0;
    const auto spread_open = [&](std::size_t row, float value) {
        // Linear between the last walked row and this one.
        const float from = rows[open_row].place.w;
        const float run = rows[row].place.w - from;
        for (std::size_t i = open_row + 1; i < row; ++i)
            rows[i].light.z = open + (value - open) * (run > 0.0F ? (rows[i].place.w - from) / run : 1.0F);
        rows[row].light.z = value;
        open = value;
        open_row = row;
        open_at_mm = rows[row].place.w;
    };
    for (std::size_t row = 0; row < chosen.points.size(); ++row) {
        const ProfilePoint& point = profile.points[chosen.points[row]];
        const bool is_edge = chosen.points[row] >= profile.edge && chosen.points[row] < profile.inside;
        const bool is_inside = profile.hollow && row >= chosen.inside;
        const vec2 normal = profile_normal(profile, point.along_mm, is_edge ? 0.6F : kNormalSpanMm);
        rows.push_back({.place = vec4(point.radius_mm, point.y_mm, texture_place(profile, point.along_mm),
                                      point.along_mm),
                        .light = vec4(normal.x, normal.y, 1.0F, is_inside ? 1.0F : 0.0F),
                        .water = vec4(column_at(lathe.wetness, point.ring, lathe.material.wetness),
                                      column_at(lathe.film, point.ring, lathe.material.film),
                                      column_at(lathe.load, point.ring, 0.0F), 0.0F)});
        const bool is_last = row + 1 == chosen.points.size();
        if (is_edge || (!profile.hollow && row >= chosen.inside)) {
            spread_open(row, 1.0F);
        } else if (is_inside) {
            if (lathe.cut)
                spread_open(row, 0.7F);
            else if (is_last || point.along_mm - open_at_mm >= kOpenEveryMm || row == chosen.inside)
                spread_open(row, open_inside(samples, point.radius_mm - 0.4F, point.y_mm + 0.1F, normal));
        } else {
            spread_open(row, open_outside(samples, point.radius_mm, point.y_mm));
        }
    }
}

}  // namespace onggi::render

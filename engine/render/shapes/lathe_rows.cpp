#include "engine/render/shapes/lathe_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace onggi::render {
namespace {

// Returns the furthest element that a chord from `from` can end at within the tolerance. Each element on the
// way narrows the interval of valid slopes; an end is valid if its own slope is inside.
std::size_t end_of_chord(const LodFace& face, std::size_t from, float tolerance, std::size_t last,
                         float max_span) {
    float lowest = -std::numeric_limits<float>::infinity();
    float highest = std::numeric_limits<float>::infinity();
    std::size_t end = from + 1;
    for (std::size_t to = from + 1; to <= last; ++to) {
        const float run = face.places_mm.empty() ? static_cast<float>(to - from)
                                                 : face.places_mm[to] - face.places_mm[from];
        if (run > max_span && to > from + 1) break;
        const float fraction = 1.0F / std::max(run, 1e-6F);
        const float rise = face.radii_mm[to] - face.radii_mm[from];
        const float slope = rise * fraction;
        if (slope >= lowest && slope <= highest) end = to;
        lowest = std::max(lowest, (rise - tolerance) * fraction);
        highest = std::min(highest, (rise + tolerance) * fraction);
        if (lowest > highest) break;
    }
    return end;
}

// Returns false as soon as more than `room` rings are needed; subtracts the rings it uses from `room`.
bool try_face(const LodFace& face, float tolerance, std::size_t max_step, float max_span, std::size_t& room,
              std::vector<std::uint32_t>& elements) {
    elements.clear();
    if (face.radii_mm.empty()) return true;
    const std::size_t top = face.radii_mm.size() - 1;
    for (std::size_t at = 0;;) {
        if (room == 0) return false;
        --room;
        elements.push_back(static_cast<std::uint32_t>(at));
        if (at >= top) return true;
        at = end_of_chord(face, at, tolerance, std::min(at + max_step, top), max_span);
    }
}

}  // namespace

std::vector<RingChoice> choose_face_rings(std::span<const LodFace> faces, const RingBudget& budget) {
    std::vector<RingChoice> choices(faces.size());
    std::size_t elements = 0;
    float span_mm = 0.0F;
    for (const LodFace& face : faces) {
        elements += face.radii_mm.size();
        if (!face.places_mm.empty()) span_mm += face.places_mm.back() - face.places_mm.front();
    }
    const auto cap = std::max(static_cast<std::size_t>(std::max(budget.max_rings, 0)),
                              2 * std::max<std::size_t>(faces.size(), 1));
    // max_step must not require more rings than the cap.
    const std::size_t shared = std::max<std::size_t>(cap - faces.size(), 1);
    const std::size_t least_step = elements == 0 ? 1 : (elements - 1) / shared + 1;
    const std::size_t max_step = std::max(static_cast<std::size_t>(std::max(budget.max_step, 1)), least_step);
    const float max_span = std::max(budget.max_span_mm, 2.0F * span_mm / static_cast<float>(shared));

    std::vector<std::vector<std::uint32_t>> tried(faces.size());
    const auto try_all = [&](float tolerance) {
        std::size_t room = cap;
        for (std::size_t face = 0; face < faces.size(); ++face) {
            if (!try_face(faces[face], tolerance, max_step, max_span, room, tried[face])) return false;
        }
        for (std::size_t face = 0; face < faces.size(); ++face)
            choices[face] = {.elements = tried[face], .tolerance_mm = tolerance};
        return true;
    };
    float too_fine = 0.0F;
    float tolerance = budget.tolerance_mm;
    while (!try_all(tolerance)) {
        too_fine = tolerance;
        tolerance = std::max(tolerance * 2.0F, 1e-4F);
        if (!std::isfinite(tolerance)) return choices;  // NaN or infinite radii are not drawn
    }
    if (too_fine > 0.0F) {
        // Bisect between the last tolerance that failed and the first that passed; four steps come within 6 %
        // of the smallest.
        for (int halving = 0; halving < 4; ++halving) {
            const float middle = 0.5F * (too_fine + tolerance);
            (try_all(middle) ? tolerance : too_fine) = middle;
        }
    }
    return choices;
}

namespace {

// Interpolates an optional column at a fractional ring; `without` if the column is empty.
float column_at(std::span<const float> column, float ring, float without) {
    if (column.empty()) return without;
    const float last = static_cast<float>(column.size() - 1);
    const float place = std::clamp(ring, 0.0F, last);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, column.size() - 1);
    return column[below] + (place - static_cast<float>(below)) * (column[above] - column[below]);
}

// Visibility test for inside points, across the axis from the eye (x < 0) or on its near side: in the
// vertical plane through eye and axis, no ring above the point may block the line of sight.
class Sight {
  public:
    Sight(const LatheProfile& profile, vec3 eye_mm, float slack_mm)
        : eye_(std::hypot(eye_mm.x, eye_mm.z), eye_mm.y) {
        const std::size_t count = profile.floor - profile.inside;
        const std::size_t stride = std::max<std::size_t>(count / kLevels, 1);
        // From the highest ring of the edge, where the wall is thinnest, downwards.
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
    // From the floor up to the deepest visible point of the far wall.
    std::size_t end = profile.floor;
    while (end > profile.inside) {
        const ProfilePoint& point = profile.points[end - 1];
        if (sight.reaches({-point.radius_mm, point.y_mm})) break;
        --end;
    }
    // A margin, because only forty levels of occluders were tested.
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

    // Both walls in ascending order of height.
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
    // Smoothing span of the normal that lights a whole row: wider than a groove.
    constexpr float kNormalSpanMm = 3.0F;
    // Spacing of the ray-marched rows; rows between them are interpolated.
    constexpr float kOpenEveryMm = 9.0F;
    rows.clear();
    float open = 1.0F;
    float open_at_mm = -1e9F;
    std::size_t open_row = 0;
    const auto spread_open = [&](std::size_t row, float value) {
        // Linear between the last ray-marched row and this one.
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

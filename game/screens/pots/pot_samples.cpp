#include "game/screens/pots/pot_samples.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "game/pot/surface_builder.h"

namespace onggi::screens {
namespace {

// The middle of an edge deviates from the circle by at most a seventh of a pixel: R (1 - cos(pi/n)).
int corners_of(float radius_px) {
    return radius_px < 48.0F ? 48 : radius_px < 192.0F ? 96 : 192;
}
// The distance between rows, no finer than the sections of pots.
float finest_mm(float px_per_mm) {
    return std::max(1.2F, 0.75F / px_per_mm);
}

float cross(vec2 a, vec2 b) {
    return a.x * b.y - a.y * b.x;
}

using Corner = PotView::Corner;

// The samples and their depths.
class Canvas {
  public:
    explicit Canvas(PotSamples& into) : into_(into), depth_(into.surface.size(), -1e9F) {}

    // Skips back faces, which front faces hide.
    void triangle(const Corner& a, const Corner& b, const Corner& c) {
        const float area = cross(b.px - a.px, c.px - a.px);
        if (area > -1e-6F) return;
        const int left = std::max(0, static_cast<int>(std::min({a.px.x, b.px.x, c.px.x})));
        const int right = std::min(into_.width - 1, static_cast<int>(std::max({a.px.x, b.px.x, c.px.x})) + 1);
        const int top = std::max(into_.top, static_cast<int>(std::min({a.px.y, b.px.y, c.px.y})));
        const int bottom =
            std::min(into_.top + into_.height - 1, static_cast<int>(std::max({a.px.y, b.px.y, c.px.y})) + 1);
        for (int y = top; y <= bottom; ++y) {
            for (int x = left; x <= right; ++x) {
                const vec2 p = place_of(x, y);
                const float u = cross(b.px - p, c.px - p) / area;
                const float v = cross(c.px - p, a.px - p) / area;
                const float w = 1.0F - u - v;
                if (u < 0.0F || v < 0.0F || w < 0.0F) continue;
                const std::size_t at =
                    static_cast<std::size_t>(y - into_.top) * static_cast<std::size_t>(into_.width) +
                    static_cast<std::size_t>(x);
                const float depth = u * a.depth + v * b.depth + w * c.depth;
                if (depth <= depth_[at]) continue;
                depth_[at] = depth;
                into_.covered[at] = 1;
                const auto between = [&](float PotSurface::*m) {
                    return u * a.surface.*m + v * b.surface.*m + w * c.surface.*m;
                };
                into_.surface[at] = {
                    between(&PotSurface::height_mm), between(&PotSurface::angle),
                    glm::normalize(u * a.surface.normal + v * b.surface.normal + w * c.surface.normal),
                    a.surface.inside};
            }
        }
    }

  private:
    // On a grid that is turned within each pixel: none of its samples share a row or a column, so that lines
    // along either, as ridges seen from the front are, pass as many of them as there are.
    [[nodiscard]] vec2 place_of(int x, int y) const {
        const int across = into_.across;
        const auto part = [&](int k) { return (static_cast<float>(k) + 0.5F) / static_cast<float>(across); };
        return {static_cast<float>(x) + part(y % across),
                static_cast<float>(y) + part(across - 1 - x % across)};
    }

    PotSamples& into_;
    std::vector<float> depth_;
};

// Inserts points about a pixel apart, so that the rings' normals are smooth.
std::vector<vec2> refined(const std::vector<vec2>& points, float most_mm) {
    std::vector<vec2> fine;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const auto at = [&](std::ptrdiff_t index) {
            const auto last = static_cast<std::ptrdiff_t>(points.size()) - 1;
            return points[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(index, 0, last))];
        };
        const auto k = static_cast<std::ptrdiff_t>(i);
        const vec2 a = at(k - 1);
        const vec2 b = at(k);
        const vec2 c = at(k + 1);
        const vec2 d = at(k + 2);
        const int pieces = std::max(1, static_cast<int>(std::ceil(glm::length(c - b) / most_mm)));
        for (int piece = 0; piece < pieces; ++piece) {
            const float t = static_cast<float>(piece) / static_cast<float>(pieces);
            // A Catmull-Rom spline (Catmull and Rom, 1974).
            const vec2 point = 0.5F * (2.0F * b + (c - a) * t + (2.0F * a - 5.0F * b + 4.0F * c - d) * t * t +
                                       (3.0F * b - a - 3.0F * c + d) * t * t * t);
            fine.push_back({std::max(0.0F, point.x), std::max(0.0F, point.y)});
        }
    }
    if (!points.empty()) fine.push_back(points.back());
    return fine;
}

// The rows' centres and dents as a picture shows them: the builder's direction 0 is at the back, and `front`
// is the clay's direction in front, in turns.
void put_off_round(pot::Walk& walk, const pot::Section& shape, float front, int corners) {
    constexpr double kLeastRadiusMm = 0.5;  // no dent pushes a wall through the axis
    const pot::OffRound& map = *shape.off_round;
    const float height_mm = std::max(shape.height_mm(), 1e-3F);
    const float at_corner_0 = front - 0.5F;
    const vec2 way(std::cos(kTurnF * at_corner_0), std::sin(kTurnF * at_corner_0));
    for (pot::SurfaceRow& row : walk.rows) {
        const float part = static_cast<float>(row.y_mm) / height_mm;
        const vec2 centre = map.centre_at(part);
        row.centre_mm = {centre.x * way.x + centre.y * way.y, centre.y * way.x - centre.x * way.y};
        for (int k = 0; k < corners && !map.dents_mm.empty(); ++k) {
            const float turns = at_corner_0 + static_cast<float>(k) / static_cast<float>(corners);
            row.dents_mm.push_back(
                std::max(double{map.dent_at(part, turns)}, std::min(kLeastRadiusMm - row.radius_mm, 0.0)));
        }
    }
}

// The section as one line: up the outside and down the inside to the floor, without rows that are nearer than
// half a pixel.
pot::Walk walk_of(const pot::Section& shape, float px_per_mm) {
    const double nearest_mm = std::max(pot::kNearestRowsMm, 0.5 / double{px_per_mm});
    pot::Walk walk;
    for (const std::vector<vec2>* side : {&shape.outside, &shape.inside}) {
        const std::vector<vec2> points = refined(*side, finest_mm(px_per_mm));
        const std::size_t first = walk.rows.size();
        for (const vec2& point : points) {
            const pot::SurfaceRow row{
                .y_mm = double{point.y}, .radius_mm = double{point.x}, .inside = side == &shape.inside};
            // A line that reaches the axis ends in a disc.
            if (row.radius_mm < pot::kNarrowestOpeningMm) continue;
            const auto is_near = [&](double within_mm) {
                return !walk.rows.empty() && distance_mm(walk.rows.back(), row) < within_mm;
            };
            if (walk.rows.size() > first + 1 && &point == &points.back() && is_near(nearest_mm))
                walk.rows.pop_back();
            if (!is_near(walk.rows.size() > first ? nearest_mm : pot::kNearestRowsMm))
                walk.rows.push_back(row);
        }
    }
    return walk;
}

}  // namespace

PotView::PotView(const pot::Section& shape, float px_per_mm, float elevation_rad, float turn,
                 int samples_across)
    : samples_across_(samples_across),
      extent_(pot_extent(shape, px_per_mm, elevation_rad)) {
    pot::Walk walk = walk_of(shape, px_per_mm);
    if (walk.rows.empty()) return;
    const int corners = corners_of(shape.radius_mm() * px_per_mm);
    if (shape.off_round) put_off_round(walk, shape, shape.front_turns() + turn, corners);
    // Unwrapped: each corner has a single angle.
    pot::SurfaceBuilder surface(corners, true);
    surface.add_walk(walk);
    surface.finish_normals();
    const auto across = static_cast<float>(samples_across);
    const float scale = px_per_mm * across;
    const float sine = std::sin(elevation_rad);
    const float cosine = std::cos(elevation_rad);
    const vec2 origin = extent_.foot_px * across;
    // The first corner is at the back, where the seam between it and the last one is hidden.
    const auto turned = [](const dvec3& way) { return vec3(way.z, way.y, -way.x); };
    corners_.resize(surface.positions_mm.size());
    for (const pot::SurfaceBuilder::Strip& strip : surface.strips()) {
        for (std::uint32_t k = 0; k < strip.count; ++k) {
            const std::uint32_t vertex = strip.first + k;
            const vec3 place = turned(surface.positions_mm[vertex]);
            corners_[vertex] = {origin + scale * vec2(place.x, -(place.y * cosine - place.z * sine)),
                                place.y * sine + place.z * cosine,
                                {.height_mm = place.y,
                                 .angle = kPiF * (2.0F * static_cast<float>(surface.turns(strip, k)) - 1.0F),
                                 .normal = turned(surface.normals[vertex]),
                                 .inside = strip.inside}};
        }
    }
    indices_ = std::move(surface.indices);
}

PotSamples PotView::samples(const PotBand& band) const {
    PotSamples samples{.width = extent_.width_px * samples_across_,
                       .height = std::min(band.height_px, extent_.height_px - band.top_px) * samples_across_,
                       .top = band.top_px * samples_across_,
                       .across = samples_across_};
    samples.surface.resize(static_cast<std::size_t>(samples.width) *
                           static_cast<std::size_t>(samples.height));
    samples.covered.resize(samples.surface.size(), 0);
    Canvas canvas(samples);
    for (std::size_t i = 0; i < indices_.size(); i += 3)
        canvas.triangle(corners_[indices_[i]], corners_[indices_[i + 1]], corners_[indices_[i + 2]]);
    return samples;
}

}  // namespace onggi::screens

#include "game/screens/pots/pot_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace onggi::screens {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kSectors = 96;

float cross(vec2 a, vec2 b) {
    return a.x * b.y - a.y * b.x;
}

struct Corner {
    vec2 px;
    float depth;
    PotSurface surface;
};

// Samples with a depth.
class Canvas {
  public:
    explicit Canvas(PotSamples& into) : into_(into), depth_(into.surface.size(), -1e9F) {}

    // What looks away from the eye lies behind what looks at it, and is left out.
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
                const vec2 p(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
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
    PotSamples& into_;
    std::vector<float> depth_;
};

// Points no further apart than a pixel or so, so that the rings' normals are smooth.
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
            // Catmull and Rom, 1974.
            const vec2 point = 0.5F * (2.0F * b + (c - a) * t + (2.0F * a - 5.0F * b + 4.0F * c - d) * t * t +
                                       (3.0F * b - a - 3.0F * c + d) * t * t * t);
            fine.push_back({std::max(0.0F, point.x), std::max(0.0F, point.y)});
        }
    }
    if (!points.empty()) fine.push_back(points.back());
    return fine;
}

}  // namespace

PotSamples sample_pot(const pot::Section& shape, float px_per_mm, float elevation_rad, const PotBand& band) {
    const float scale = px_per_mm * kSamplesAcross;
    const float sine = std::sin(elevation_rad);
    const float cosine = std::cos(elevation_rad);
    const PotExtent extent = pot_extent(shape, px_per_mm, elevation_rad);
    PotSamples samples{.width = extent.width_px * kSamplesAcross,
                       .height = std::min(band.height_px, extent.height_px - band.top_px) * kSamplesAcross,
                       .top = band.top_px * kSamplesAcross,
                       .foot_px = extent.foot_px};
    const vec2 origin = extent.foot_px * static_cast<float>(kSamplesAcross);
    samples.surface.resize(static_cast<std::size_t>(samples.width) *
                           static_cast<std::size_t>(samples.height));
    samples.covered.resize(samples.surface.size(), 0);

    // The whole section as one line, up the outside and down the inside.
    std::vector<vec2> section = refined(shape.outside, 1.2F);
    const std::size_t outside_count = section.size();
    if (!shape.inside.empty()) {
        const std::vector<vec2> inner = refined(shape.inside, 1.2F);
        section.insert(section.end(), inner.begin(), inner.end());
    } else if (!section.empty()) {
        section.push_back({0.0F, section.back().y});
    }
    // The first sector is at the back, where what differs between it and the last is not seen.
    struct Direction {
        float angle;
        vec2 way;  // x right, z to the eye
    };
    std::array<Direction, kSectors + 1> directions;
    for (int sector = 0; sector <= kSectors; ++sector) {
        const float angle = 2.0F * kPi * static_cast<float>(sector) / kSectors - kPi;
        directions[static_cast<std::size_t>(sector)] = {angle, {std::sin(angle), std::cos(angle)}};
    }
    Canvas canvas(samples);
    const auto corner = [&](std::size_t ring, int sector) {
        const vec2 before = section[ring == 0 ? 0 : ring - 1];
        const vec2 after = section[std::min(ring + 1, section.size() - 1)];
        vec2 along = after - before;
        const float length = glm::length(along);
        along = length > 0.0F ? along / length : vec2(0.0F, 1.0F);
        const auto& [angle, way] = directions[static_cast<std::size_t>(sector)];
        const vec2 at = section[ring];
        const vec3 normal(way.x * along.y, -along.x, way.y * along.y);
        const vec3 place(at.x * way.x, at.y, at.x * way.y);
        return Corner{origin + scale * vec2(place.x, -(place.y * cosine - place.z * sine)),
                      place.y * sine + place.z * cosine,
                      {at.y, angle, normal, ring >= outside_count}};
    };
    // Whether any of a ring may be seen in the band: a pixel more each way, for what is rounded.
    const auto first_row = static_cast<float>(samples.top - 2 * kSamplesAcross);
    const auto last_row = static_cast<float>(samples.top + samples.height + 2 * kSamplesAcross);
    const auto highest_row = [&](std::size_t ring) {
        return origin.y - scale * (section[ring].y * cosine + section[ring].x * std::abs(sine));
    };
    const auto lowest_row = [&](std::size_t ring) {
        return origin.y - scale * (section[ring].y * cosine - section[ring].x * std::abs(sine));
    };
    for (std::size_t ring = 0; ring + 1 < section.size(); ++ring) {
        if (std::max(lowest_row(ring), lowest_row(ring + 1)) < first_row ||
            std::min(highest_row(ring), highest_row(ring + 1)) > last_row)
            continue;
        for (int sector = 0; sector < kSectors; ++sector) {
            const Corner a = corner(ring, sector);
            const Corner b = corner(ring, sector + 1);
            const Corner c = corner(ring + 1, sector);
            const Corner d = corner(ring + 1, sector + 1);
            canvas.triangle(a, b, c);
            canvas.triangle(b, d, c);
        }
    }
    return samples;
}

}  // namespace onggi::screens

#include "game/screens/pot_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/hash.h"

namespace onggi::screens {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kSectors = 96;
constexpr int kOver = 2;  // samples a pixel, each way
constexpr float kMarginPx = 2.0F;

float hashed(int x, int y) {
    auto n = static_cast<std::uint32_t>(x) * 374761393U + static_cast<std::uint32_t>(y) * 668265263U;
    n = (n ^ (n >> 13U)) * 1274126177U;
    return static_cast<float>((n ^ (n >> 16U)) & 0xffffU) / 65535.0F;
}

// Smooth noise of two numbers, 0 to 1.
float noise(float x, float y) {
    const float fx = std::floor(x);
    const float fy = std::floor(y);
    const int ix = static_cast<int>(fx);
    const int iy = static_cast<int>(fy);
    const float u = glm::smoothstep(0.0F, 1.0F, x - fx);
    const float v = glm::smoothstep(0.0F, 1.0F, y - fy);
    return glm::mix(glm::mix(hashed(ix, iy), hashed(ix + 1, iy), u),
                    glm::mix(hashed(ix, iy + 1), hashed(ix + 1, iy + 1), u), v);
}

// What one sample of the surface is.
struct Surface {
    float radius_mm;
    float height_mm;
    float angle;  // about the axis, of the pot itself
    vec3 normal;
    bool inside;
};

class Lamp {
  public:
    Lamp(const finish::GlazeMaterial& glaze, float height_mm, float elevation_rad)
        : glaze_(glaze),
          height_mm_(height_mm),
          to_eye_(0.0F, std::sin(elevation_rad), std::cos(elevation_rad)) {}

    // Linear light.
    [[nodiscard]] vec3 shade(const Surface& at) const {
        // The fingers' rings: finer than the outline, so they are drawn into the normal and the colour.
        const float ring = std::sin(at.height_mm * 1.05F + 1.3F * noise(at.height_mm * 0.11F, 2.0F)) * 0.5F +
                           (noise(at.height_mm * 0.8F, at.angle * 0.6F) - 0.5F);
        vec3 normal = glm::normalize(at.normal + vec3(0.0F, 0.045F * ring, 0.0F));
        const bool is_foot = !at.inside && at.height_mm < glaze_.foot_bare_mm;
        const vec3 albedo = is_foot ? glaze_.body : colour(at, ring);

        const float facing = glm::dot(normal, kKey);
        const float key = glm::clamp((facing + 0.25F) / 1.25F, 0.0F, 1.0F);
        const float sky = 0.5F + 0.5F * normal.y;
        const float fill = glm::clamp(glm::dot(normal, kFill), 0.0F, 1.0F);
        // The shelf sends warm light back up, and closes off the foot from the sky.
        const float shelf = glm::clamp(-normal.y, 0.0F, 1.0F) * 0.18F;
        const float closed = 1.0F - 0.55F * std::exp(-at.height_mm / (0.08F * height_mm_ + 2.0F));
        float open = at.inside ? depth_light(at) : closed;
        vec3 light = kKeyLight * (key * key) + vec3(0.30F, 0.29F, 0.28F) * sky +
                     vec3(0.16F, 0.14F, 0.12F) * fill + vec3(0.9F, 0.65F, 0.42F) * shelf;
        vec3 result = albedo * light * open;

        const float coat = is_foot ? 0.0F : glaze_.clear_coat;
        if (coat > 0.0F) {
            const float cosine = glm::clamp(glm::dot(normal, to_eye_), 0.0F, 1.0F);
            const float f0 =
                (glaze_.ior - 1.0F) * (glaze_.ior - 1.0F) / ((glaze_.ior + 1.0F) * (glaze_.ior + 1.0F));
            const float fresnel = coat * (f0 + (1.0F - f0) * std::pow(1.0F - cosine, 5.0F));
            result = result * (1.0F - fresnel) + reflected(glm::reflect(-to_eye_, normal)) * (fresnel * open);
        } else {
            const vec3 half = glm::normalize(kKey + to_eye_);
            result += vec3(0.03F) * std::pow(glm::clamp(glm::dot(normal, half), 0.0F, 1.0F), 12.0F) * open;
        }
        return result;
    }

  private:
    [[nodiscard]] vec3 colour(const Surface& at, float ring) const {
        float thick =
            0.5F + 0.5F * noise(at.height_mm * 0.05F, at.angle * 1.5F + 7.0F) - glaze_.breaks * 0.20F * ring;
        // Glaze draws back from a rim.
        thick -= glaze_.breaks * 0.9F * std::exp(-(height_mm_ - at.height_mm) / 2.2F);
        if (glaze_.brushed > 0.0F) {
            const float streak = noise(at.height_mm * 1.15F, at.angle * 0.9F + 0.04F * at.height_mm) * 0.62F +
                                 noise(at.height_mm * 3.1F, at.angle * 0.5F) * 0.38F;
            thick = glm::mix(thick, glm::smoothstep(0.30F, 0.58F, streak), glaze_.brushed);
        }
        if (glaze_.runs > 0.0F) {
            const float drop =
                noise(at.angle * 9.0F, 1.0F) * 0.6F + noise(at.angle * 23.0F, at.height_mm * 0.03F) * 0.4F;
            const float high = at.height_mm / height_mm_;
            thick += glaze_.runs * (drop - 0.5F) * 0.9F + glaze_.runs * (high - 0.55F) * 0.5F;
        }
        thick = glm::clamp(thick, 0.0F, 1.0F);
        const float grain = 0.97F + 0.06F * noise(at.height_mm * 2.3F, at.angle * 31.0F);
        return glm::mix(glaze_.thin_colour, glaze_.colour, thick) * grain;
    }
    // Less light the deeper inside.
    [[nodiscard]] float depth_light(const Surface& at) const {
        return 0.22F + 0.78F * std::exp(-(height_mm_ - at.height_mm) / (0.22F * height_mm_ + 4.0F));
    }
    // A tall window with one bar on the left, a pale room elsewhere.
    [[nodiscard]] vec3 reflected(const vec3& direction) const {
        const float softness = 0.02F + 0.35F * glaze_.coat_roughness;
        const auto within = [&](float value, float low, float high) {
            return glm::smoothstep(low - softness, low + softness, value) *
                   (1.0F - glm::smoothstep(high - softness, high + softness, value));
        };
        const float side = std::atan2(direction.x, std::max(0.05F, direction.z));
        const float up = direction.y;
        const float bar = 1.0F - 0.7F * within(side, -0.93F, -0.87F);
        const float window = within(side, -1.28F, -0.55F) * within(up, 0.05F, 0.80F) * bar;
        return vec3(0.10F, 0.09F, 0.08F) * (1.0F + up) + vec3(4.2F, 4.3F, 4.4F) * window;
    }

    static inline const vec3 kKey = glm::normalize(vec3(-0.62F, 0.50F, 0.60F));
    static inline const vec3 kFill = glm::normalize(vec3(0.85F, 0.15F, 0.50F));
    static constexpr vec3 kKeyLight{1.02F, 0.97F, 0.88F};
    const finish::GlazeMaterial& glaze_;
    float height_mm_;
    vec3 to_eye_;
};

// Pixels with a depth, twice as fine each way as the picture.
class Canvas {
  public:
    Canvas(int width, int height)
        : width_(width),
          height_(height),
          depth_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), -1e9F),
          colour_(depth_.size(), vec3(0.0F)),
          covered_(depth_.size(), 0) {}

    struct Corner {
        vec2 px;
        float depth;
        Surface surface;
    };
    void triangle(const Corner& a, const Corner& b, const Corner& c, const Lamp& lamp) {
        const float area = cross(b.px - a.px, c.px - a.px);
        if (std::abs(area) < 1e-6F) return;
        const int left = std::max(0, static_cast<int>(std::min({a.px.x, b.px.x, c.px.x})));
        const int right = std::min(width_ - 1, static_cast<int>(std::max({a.px.x, b.px.x, c.px.x})) + 1);
        const int top = std::max(0, static_cast<int>(std::min({a.px.y, b.px.y, c.px.y})));
        const int bottom = std::min(height_ - 1, static_cast<int>(std::max({a.px.y, b.px.y, c.px.y})) + 1);
        for (int y = top; y <= bottom; ++y) {
            for (int x = left; x <= right; ++x) {
                const vec2 p(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
                const float u = cross(b.px - p, c.px - p) / area;
                const float v = cross(c.px - p, a.px - p) / area;
                const float w = 1.0F - u - v;
                if (u < 0.0F || v < 0.0F || w < 0.0F) continue;
                const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                       static_cast<std::size_t>(x);
                const float depth = u * a.depth + v * b.depth + w * c.depth;
                if (depth <= depth_[at]) continue;
                depth_[at] = depth;
                covered_[at] = 1;
                const auto between = [&](float Surface::*m) {
                    return u * a.surface.*m + v * b.surface.*m + w * c.surface.*m;
                };
                colour_[at] = lamp.shade(
                    {between(&Surface::radius_mm), between(&Surface::height_mm), between(&Surface::angle),
                     glm::normalize(u * a.surface.normal + v * b.surface.normal + w * c.surface.normal),
                     a.surface.inside});
            }
        }
    }

    [[nodiscard]] ui::Painting resolved() const {
        ui::Painting painting;
        painting.width = width_ / kOver;
        painting.height = height_ / kOver;
        painting.rgba.resize(static_cast<std::size_t>(painting.width) *
                             static_cast<std::size_t>(painting.height) * 4);
        std::uint8_t* to = painting.rgba.data();
        for (int y = 0; y < painting.height; ++y) {
            for (int x = 0; x < painting.width; ++x, to += 4) {
                vec3 sum(0.0F);
                int count = 0;
                for (int k = 0; k < kOver * kOver; ++k) {
                    const std::size_t at =
                        static_cast<std::size_t>(y * kOver + k / kOver) * static_cast<std::size_t>(width_) +
                        static_cast<std::size_t>(x * kOver + k % kOver);
                    if (covered_[at] == 0) continue;
                    sum += encoded(colour_[at]);
                    ++count;
                }
                for (int channel = 0; channel < 3; ++channel)
                    to[channel] = static_cast<std::uint8_t>(sum[channel] * 255.0F / (kOver * kOver) + 0.5F);
                to[3] = static_cast<std::uint8_t>(count * 255 / (kOver * kOver));
            }
        }
        return painting;
    }

  private:
    static float cross(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }
    // A soft shoulder for the highlights, then sRGB, nearly.
    static vec3 encoded(const vec3& light) {
        const vec3 mapped = light * (1.0F + light / 6.0F) / (1.0F + 0.55F * light);
        return glm::clamp(glm::pow(glm::max(mapped, vec3(0.0F)), vec3(1.0F / 2.2F)), vec3(0.0F), vec3(1.0F));
    }

    int width_;
    int height_;
    std::vector<float> depth_;
    std::vector<vec3> colour_;
    std::vector<std::uint8_t> covered_;
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

float PotShape::height_mm() const {
    float highest = 0.0F;
    for (const vec2& point : outside)
        highest = std::max(highest, point.y);
    return highest;
}

float PotShape::radius_mm() const {
    float widest = 0.0F;
    for (const vec2& point : outside)
        widest = std::max(widest, point.x);
    return widest;
}

std::uint64_t PotShape::hash() const {
    StateHash hash;
    for (const std::vector<vec2>* side : {&outside, &inside}) {
        hash.add_word(side->size());
        for (const vec2& point : *side)
            hash.add(double{point.x}), hash.add(double{point.y});
    }
    return hash.value();
}

PotShape hollowed(std::vector<vec2> outside, float wall_mm, float floor_mm) {
    PotShape shape{.outside = std::move(outside), .inside = {}};
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

PotPicture paint_pot(const PotShape& shape, const finish::GlazeMaterial& glaze, float px_per_mm,
                     float elevation_rad, float turn) {
    const float scale = px_per_mm * kOver;
    const float sine = std::sin(elevation_rad);
    const float cosine = std::cos(elevation_rad);
    const float radius_mm = shape.radius_mm();
    const float height_mm = shape.height_mm();
    const float margin = kMarginPx * kOver;
    const float half_width = radius_mm * scale + margin;
    const float above = (height_mm * cosine + radius_mm * sine) * scale + margin;
    const float below = radius_mm * sine * scale + margin;
    const auto pixels = [](float value) {
        return std::max(1, static_cast<int>(std::ceil(value / kOver))) * kOver;
    };
    const int width = pixels(2.0F * half_width);
    const int height = pixels(above + below);
    const vec2 origin(0.5F * static_cast<float>(width), above);

    // The whole section as one line, up the outside and down the inside.
    std::vector<vec2> section = refined(shape.outside, 1.2F);
    const std::size_t outside_count = section.size();
    if (!shape.inside.empty()) {
        const std::vector<vec2> inner = refined(shape.inside, 1.2F);
        section.insert(section.end(), inner.begin(), inner.end());
    } else if (!section.empty()) {
        section.push_back({0.0F, section.back().y});
    }
    Canvas canvas(width, height);
    const Lamp lamp(glaze, height_mm, elevation_rad);
    const auto corner = [&](std::size_t ring, int sector) {
        const vec2 before = section[ring == 0 ? 0 : ring - 1];
        const vec2 after = section[std::min(ring + 1, section.size() - 1)];
        vec2 along = after - before;
        const float length = glm::length(along);
        along = length > 0.0F ? along / length : vec2(0.0F, 1.0F);
        // The first sector is at the back, where what differs between it and the last is not seen.
        const float angle = 2.0F * kPi * static_cast<float>(sector) / kSectors - kPi;
        const vec2 way(std::sin(angle), std::cos(angle));  // x right, z to the eye
        const vec2 at = section[ring];
        const vec3 normal(way.x * along.y, -along.x, way.y * along.y);
        const vec3 place(at.x * way.x, at.y, at.x * way.y);
        return Canvas::Corner{origin + scale * vec2(place.x, -(place.y * cosine - place.z * sine)),
                              place.y * sine + place.z * cosine,
                              {at.x, at.y, angle + 2.0F * kPi * turn, normal, ring >= outside_count}};
    };
    for (std::size_t ring = 0; ring + 1 < section.size(); ++ring) {
        for (int sector = 0; sector < kSectors; ++sector) {
            const auto a = corner(ring, sector);
            const auto b = corner(ring, sector + 1);
            const auto c = corner(ring + 1, sector);
            const auto d = corner(ring + 1, sector + 1);
            canvas.triangle(a, b, c, lamp);
            canvas.triangle(b, d, c, lamp);
        }
    }
    return {.painting = canvas.resolved(), .foot_px = origin / static_cast<float>(kOver)};
}

}  // namespace onggi::screens

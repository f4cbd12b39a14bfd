// The shapes that a bent photograph is drawn as: which lines of the picture they reach, and how what they
// show grows over them. Inline, as bend_rows.h. Any thread; pure. Pixels, texels.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/render/bend_pixels.h"
#include "engine/render/bend_rows.h"

namespace onggi::render::bend {

// The pixel whose middle is the first at or after an edge.
[[gnu::always_inline]] inline int first_pixel(float edge, int most) {
    return static_cast<int>(std::clamp(std::ceil(edge - 0.5F), 0.0F, static_cast<float>(most)));
}

// From where to where a shape reaches in each line of the picture; only its own lines are good.
struct Reach {
    explicit Reach(const BentPicture& picture)
        : left(static_cast<std::size_t>(picture.height)),
          right(static_cast<std::size_t>(picture.height)) {}
    std::vector<int> left;
    std::vector<int> right;
    int top = 0;
    int end = 0;
};

// A convex shape of three or four corners, and how its values grow from pixel to pixel.
template <std::size_t kValues>
struct Shape {
    std::array<const BentCorner<kValues>*, 4> corners;
    std::size_t count = 3;
    std::array<float, kValues + 1> across;  // the last: depth
    std::array<float, kValues + 1> down;

    [[nodiscard]] float value(std::size_t corner, std::size_t number) const {
        return number < kValues ? corners[corner]->values[number] : corners[corner]->depth;
    }
    // Of a value, from this pixel on.
    [[nodiscard]] Slope slope(std::size_t number, int x, int y) const {
        const vec2 from = corners[0]->at_px;
        return {value(0, number) + across[number] * (static_cast<float>(x) + 0.5F - from.x) +
                    down[number] * (static_cast<float>(y) + 0.5F - from.y),
                across[number]};
    }
    template <typename Is>
    [[nodiscard]] bool all(std::size_t number, Is is) const {
        for (std::size_t i = 0; i < count; ++i) {
            if (!is(corners[i]->values[number])) return false;
        }
        return true;
    }
};

// Twice the area; above 0 where the corners go clockwise in a picture whose y points down.
[[gnu::always_inline]] inline float area_of(vec2 a, vec2 b, vec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Where an edge passes the lines it reaches. The same for both shapes at it, so no pixel is left out between
// them and none is drawn twice.
[[gnu::always_inline]] inline void walk(vec2 from, vec2 to, const BentPicture& picture,
                                        std::vector<int>& into) {
    const int end = first_pixel(to.y, picture.height);
    int y = first_pixel(from.y, picture.height);
    if (y >= end) return;
    const float lean = (to.x - from.x) / (to.y - from.y);
    const float first = from.x + (static_cast<float>(y) + 0.5F - from.y) * lean;
    constexpr float kMost = 1e9F;
    const auto in_fixed = [&](float px) {
        return static_cast<std::int64_t>(std::clamp(px, -kMost, kMost) * static_cast<float>(kOne));
    };
    const std::int64_t step = in_fixed(lean);
    const std::int64_t most = picture.width;
    for (std::int64_t x = in_fixed(first) + kOne / 2 - 1; y < end; ++y, x += step)
        into[static_cast<std::size_t>(y)] = static_cast<int>(std::clamp(x >> 16, std::int64_t{0}, most));
}

// Which lines a shape reaches, and how far.
template <std::size_t kValues>
[[gnu::always_inline]] inline void find_reach(const Shape<kValues>& shape, bool is_clockwise,
                                              const BentPicture& picture, Reach& reach) {
    float top = shape.corners[0]->at_px.y;
    float low = top;
    for (std::size_t i = 0; i < shape.count; ++i) {
        const vec2 from = shape.corners[i]->at_px;
        const vec2 to = shape.corners[i + 1 < shape.count ? i + 1 : 0]->at_px;
        top = std::min(top, from.y);
        low = std::max(low, from.y);
        // Clockwise, what goes down is on the right.
        if (from.y < to.y) walk(from, to, picture, is_clockwise ? reach.right : reach.left);
        if (to.y < from.y) walk(to, from, picture, is_clockwise ? reach.left : reach.right);
    }
    reach.top = first_pixel(top, picture.height);
    reach.end = first_pixel(low, picture.height);
}

// From the first three corners.
template <std::size_t kValues>
[[gnu::always_inline]] inline void find_slopes(Shape<kValues>& shape, float area) {
    const vec2 from = shape.corners[0]->at_px;
    const vec2 a = (shape.corners[1]->at_px - from) / area;
    const vec2 b = (shape.corners[2]->at_px - from) / area;
    for (std::size_t i = 0; i <= kValues; ++i) {
        const float of_a = shape.value(1, i) - shape.value(0, i);
        const float of_b = shape.value(2, i) - shape.value(0, i);
        shape.across[i] = of_a * b.y - of_b * a.y;
        shape.down[i] = of_b * a.x - of_a * b.x;
    }
}

constexpr float kNoArea = 1e-5F;

// Place of a shape in a photograph in whole numbers, sixteen bits behind the point; only of a shape for which
// is_inside() says that they will do.
class FixedPlace {
  public:
    FixedPlace() = default;
    template <std::size_t kValues>
    [[gnu::always_inline]] FixedPlace(const Shape<kValues>& shape, std::size_t u)
        : x_(static_cast<int>(shape.corners[0]->at_px.x)),
          y_(static_cast<int>(shape.corners[0]->at_px.y)),
          u_(plane(shape, u)),
          v_(plane(shape, u + 1)) {}

    [[nodiscard]] FixedRow row(int x, int y) const {
        return {at(u_, x, y), u_.across, at(v_, x, y), v_.across};
    }

  private:
    struct Plane {
        int first = 0;  // at the first corner's pixel
        int across = 0;
        int down = 0;
    };
    template <std::size_t kValues>
    [[nodiscard]] Plane plane(const Shape<kValues>& shape, std::size_t number) const {
        return {fixed(shape.slope(number, x_, y_).first), fixed(shape.across[number]),
                fixed(shape.down[number])};
    }
    [[nodiscard]] int at(const Plane& plane, int x, int y) const {
        return plane.first + plane.across * (x - x_) + plane.down * (y - y_);
    }

    int x_ = 0;
    int y_ = 0;
    Plane u_;
    Plane v_;
};

// Whether all of a shape lies inside a photograph, and shows it at about its own size.
template <std::size_t kValues>
[[gnu::always_inline]] inline bool is_plain(const Shape<kValues>& shape, std::size_t u,
                                            const HostPhotograph& photograph) {
    constexpr float kChange = static_cast<float>(kMostChange) / kOne;
    constexpr float kTallest = 8.0F;  // texels from line to line
    constexpr float kWidePx = 512.0F;
    if (!(std::abs(shape.across[u] - 1.0F) < kChange && std::abs(shape.across[u + 1]) < kChange &&
          std::abs(shape.down[u]) < kTallest && std::abs(shape.down[u + 1]) < kTallest))
        return false;
    const vec2 from = shape.corners[0]->at_px;
    for (std::size_t i = 0; i < shape.count; ++i) {
        const vec2 away = glm::abs(shape.corners[i]->at_px - from);
        const float in_u = shape.corners[i]->values[u];
        const float in_v = shape.corners[i]->values[u + 1];
        // A block may reach beyond the shape.
        constexpr float kBeyond = 2.0F;
        if (away.x > kWidePx || away.y > kWidePx || in_u < kBeyond || in_v < kBeyond ||
            in_u > static_cast<float>(photograph.width()) - kBeyond ||
            in_v > static_cast<float>(photograph.height()) - kBeyond)
            return false;
    }
    return true;
}

}  // namespace onggi::render::bend

// Where the shapes of a bent photograph lie in it, in whole numbers. Inline, as bend_rows.h. Any thread;
// pure. Pixels, texels.
#pragma once

#include <cmath>
#include <cstddef>

#include "engine/render/pixels/bend_pixels.h"
#include "engine/render/pixels/bend_rows.h"

namespace onggi::render::bend {

using shapes::Shape;

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

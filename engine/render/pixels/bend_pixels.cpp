#include "engine/render/pixels/bend_pixels.h"

#include <cmath>

#include "engine/render/pixels/bend_rows.h"
#include "engine/render/pixels/bend_shapes.h"
#include "engine/render/pixels/wide_vectors.h"

namespace onggi::render {
namespace {

using bend::FixedPlace;
using shapes::kNoArea;
using shapes::Reach;
using shapes::Shape;
using shapes::Slope;

// How much of the second plate is none of it, and how much is all.
constexpr float kNone = 1.0F / 512.0F;
constexpr float kAll = 1.0F - kNone;

bool is_none(float share) {
    return share < kNone;
}
bool is_all(float share) {
    return share > kAll;
}

// Which of the two plates a shape shows.
enum class Shows { kFrom, kTo, kBoth };
template <std::size_t kValues>
[[gnu::always_inline]] inline Shows shown_by(const Shape<kValues>& shape) {
    if (shape.all(kToShare, is_none)) return Shows::kFrom;
    return shape.all(kToShare, is_all) ? Shows::kTo : Shows::kBoth;
}

// What a shape takes of the photographs.
template <std::size_t kValues>
class Taker {
  public:
    [[gnu::always_inline]] Taker(const Shape<kValues>& shape, const BentPicture& picture)
        : shape_(shape),
          shows_(shown_by(shape)),
          is_plain_((shows_ == Shows::kTo || bend::is_plain(shape, kFromU, picture.from->key)) &&
                    (shows_ == Shows::kFrom || bend::is_plain(shape, kToU, picture.to->key))) {
        if (!is_plain_) return;
        if (shows_ != Shows::kTo) from_ = FixedPlace(shape, kFromU);
        if (shows_ != Shows::kFrom) to_ = FixedPlace(shape, kToU);
    }

    [[gnu::always_inline]] void take(const HostPhotograph& from, const HostPhotograph& to, int x, int y,
                                     std::uint32_t* pixels, int count) const {
        const auto slope = [&](std::size_t number) __attribute__((always_inline)) {
            return shape_.slope(number, x, y);
        };
        if (shows_ == Shows::kBoth) {
            const Slope share = slope(kToShare);
            if (is_plain_) {
                bend::take_inside(from, from_.row(x, y), to, to_.row(x, y), bend::fixed(share.first),
                                  bend::fixed(share.step), pixels, count);
            } else {
                bend::take_both(from, {slope(kFromU), slope(kFromV)}, to, {slope(kToU), slope(kToV)}, share,
                                pixels, count);
            }
            return;
        }
        const bool is_to = shows_ == Shows::kTo;
        if (is_plain_) {
            bend::take_inside(is_to ? to : from, (is_to ? to_ : from_).row(x, y), pixels, count);
        } else {
            const std::size_t u = is_to ? kToU : kFromU;
            bend::take_one(is_to ? to : from, {slope(u), slope(u + 1)}, pixels, count);
        }
    }

  private:
    const Shape<kValues>& shape_;
    Shows shows_;
    bool is_plain_;
    FixedPlace from_;
    FixedPlace to_;
};

[[gnu::always_inline]] inline void draw(const Shape<kReliefValues>& shape, const BentPicture& picture,
                                        const Reach& reach) {
    const Taker taker(shape, picture);
    const bool is_shaded = !shape.all(kSeen, is_all);
    for (int y = reach.top; y < reach.end; ++y) {
        const int left = reach.left[static_cast<std::size_t>(y)];
        const int count = reach.right[static_cast<std::size_t>(y)] - left;
        if (count <= 0) continue;
        std::uint32_t* const pixels =
            picture.pixels.data() + static_cast<std::ptrdiff_t>(y) * picture.width + left;
        taker.take(picture.from->key, picture.to->key, left, y, pixels, count);
        if (is_shaded) bend::shade_softly(shape.slope(kSeen, left, y), picture.order, pixels, count);
        if (picture.dimmed != nullptr) bend::dim(*picture.dimmed, pixels, count);
    }
}

// Whether the last of four corners lies in the plane of the others, as nearly as one can see.
[[gnu::always_inline]] inline bool is_plane(const Shape<kReliefValues>& shape) {
    constexpr std::array<float, kReliefValues> kAlike{0.15F, 0.15F, 0.15F, 0.15F, 0.02F, 0.02F};
    const vec2 away = shape.corners[3]->at_px - shape.corners[0]->at_px;
    for (std::size_t i = 0; i < kReliefValues; ++i) {
        const float expected =
            shape.corners[0]->values[i] + shape.across[i] * away.x + shape.down[i] * away.y;
        if (!(std::abs(expected - shape.corners[3]->values[i]) < kAlike[i])) return false;
    }
    return true;
}

[[gnu::always_inline]] inline void draw_three(Shape<kReliefValues>& shape, const BentPicture& picture,
                                              Reach& reach) {
    const float area =
        shapes::area_of(shape.corners[0]->at_px, shape.corners[1]->at_px, shape.corners[2]->at_px);
    if (std::abs(area) < kNoArea) return;
    shape.count = 3;
    shapes::find_slopes(shape, area);
    shapes::find_reach(shape, area > 0.0F, picture.size(), reach);
    draw(shape, picture, reach);
}

[[gnu::always_inline]] inline void bend_all(std::span<const ReliefCorner> corners,
                                            std::span<const Quad> quads, const BentPicture& picture) {
    Reach reach(picture.size());
    Shape<kReliefValues> shape;
    for (const Quad& quad : quads) {
        std::array<const ReliefCorner*, 4> own;
        for (std::size_t i = 0; i < own.size(); ++i)
            own[i] = &corners[quad[i]];
        if (own[0]->away_mm <= 0.0F || own[1]->away_mm <= 0.0F || own[2]->away_mm <= 0.0F ||
            own[3]->away_mm <= 0.0F)
            continue;
        shape.corners = own;
        shape.count = 4;
        const auto turn = [&](std::size_t a, std::size_t b, std::size_t c) {
            return shapes::area_of(own[a]->at_px, own[b]->at_px, own[c]->at_px);
        };
        const float first = turn(0, 1, 2);
        const bool is_convex =
            first > kNoArea && turn(1, 2, 3) > kNoArea && turn(2, 3, 0) > kNoArea && turn(3, 0, 1) > kNoArea;
        if (is_convex) {
            shapes::find_slopes(shape, first);
            if (is_plane(shape)) {
                shapes::find_reach(shape, true, picture.size(), reach);
                draw(shape, picture, reach);
                continue;
            }
        }
        shape.corners = {own[0], own[3], own[1], nullptr};
        draw_three(shape, picture, reach);
        shape.corners = {own[1], own[3], own[2], nullptr};
        draw_three(shape, picture, reach);
    }
}

// Pixels of a surface's row that are drawn at a time.
constexpr int kPiece = 16;

// The mask at a place of it, 0 to 1: key light and sky, times 65536 x 255.
struct Shade {
    std::uint32_t key = 0;
    std::uint32_t sky = 0;
};
[[gnu::always_inline]] inline Shade shade_at(const ShadowMask& mask, float u, float v) {
    constexpr std::uint32_t kAcross = shaders::kMaskTexels;
    constexpr float kMost = 256.0F * (kAcross - 1) - 1.0F;
    const auto steps = [&](float at) {
        const float texel = (at * kAcross - 0.5F) * 256.0F;
        return static_cast<std::uint32_t>(static_cast<int>(std::clamp(texel, 0.0F, kMost)));
    };
    const std::uint32_t across = steps(u);
    const std::uint32_t down = steps(v);
    const std::uint32_t* const texel = mask.data() + (down >> 8U) * kAcross + (across >> 8U);
    const std::uint32_t right = across & 255U;
    const std::uint32_t below = down & 255U;
    const std::uint32_t near_row = texel[0] * (256U - right) + texel[1] * right;
    const std::uint32_t far_row = texel[kAcross] * (256U - right) + texel[kAcross + 1] * right;
    return {.key = (near_row & 0xFFFFU) * (256U - below) + (far_row & 0xFFFFU) * below,
            .sky = (near_row >> 16U) * (256U - below) + (far_row >> 16U) * below};
}

// Whether nothing of the mask that a shape lies in is in shade.
[[gnu::always_inline]] inline bool is_open(const Shape<kSurfaceValues>& shape, const ShadowMask& mask) {
    constexpr int kAcross = shaders::kMaskTexels;
    const auto texels = [&](std::size_t number) {
        float least = shape.corners[0]->values[number];
        float most = least;
        for (std::size_t i = 1; i < shape.count; ++i) {
            least = std::min(least, shape.corners[i]->values[number]);
            most = std::max(most, shape.corners[i]->values[number]);
        }
        const auto texel = [](float at) {
            return static_cast<int>(std::clamp(at * kAcross - 0.5F, 0.0F, kAcross - 2.0F));
        };
        return std::pair(texel(least), texel(most) + 1);
    };
    const auto [left, right] = texels(kMaskU);
    const auto [top, low] = texels(kMaskV);
    std::uint32_t all = kUnshaded;
    for (int row = top; row <= low; ++row) {
        for (int column = left; column <= right; ++column)
            all &= mask[static_cast<std::size_t>(row * kAcross + column)];
    }
    return all == kUnshaded;
}

// A few pixels of a surface, none of them hidden, with the shade on it.
[[gnu::always_inline]] inline void draw_shaded(const Shape<kSurfaceValues>& shape,
                                               const Taker<kSurfaceValues>& taker, const BentPicture& picture,
                                               int x, int y, std::uint32_t* pixels, int count) {
    std::array<std::uint32_t, kPiece> unlit;
    taker.take(picture.from->ambient, picture.to->ambient, x, y, unlit.data(), count);
    const Slope u = shape.slope(kMaskU, x, y);
    const Slope v = shape.slope(kMaskV, x, y);
    const Slope near_foot = shape.slope(kNearFoot, x, y);
    for (int i = 0; i < count; ++i) {
        constexpr float kOneOverAll = 1.0F / (255.0F * 65536.0F);
        const Shade here = shade_at(*picture.mask, u.at(i), v.at(i));
        const int lit = bend::part_of_256(static_cast<float>(static_cast<int>(here.key)) * kOneOverAll);
        const float open = static_cast<float>(static_cast<int>(here.sky)) * kOneOverAll;
        // As shaders/glide.frag has it, a share of the light in the values of the screen.
        const int left = bend::part_of_256(std::sqrt(1.0F + (open - 1.0F) * near_foot.at(i)));
        const bend::Halves value =
            bend::mixed(bend::unpacked(unlit[static_cast<std::size_t>(i)]), bend::unpacked(pixels[i]), lit);
        pixels[i] = bend::packed(bend::mixed(bend::Halves{}, value, left)) | 0xFF000000U;
    }
}

[[gnu::always_inline]] inline void draw(const Shape<kSurfaceValues>& shape, const BentPicture& picture,
                                        const Reach& reach) {
    const Taker taker(shape, picture);
    const bool is_shaded = !is_open(shape, *picture.mask);
    for (int y = reach.top; y < reach.end; ++y) {
        const int left = reach.left[static_cast<std::size_t>(y)];
        const int right = reach.right[static_cast<std::size_t>(y)];
        if (left >= right) continue;
        float* const depth = picture.depth.data() + static_cast<std::ptrdiff_t>(y) * picture.width;
        const Slope own = shape.slope(kSurfaceValues, left, y);
        for (int x = left; x < right;) {
            int count = 0;
            for (; count < kPiece && x + count < right; ++count) {
                const float here = own.at(x + count - left);
                if (here >= depth[x + count]) break;
                depth[x + count] = here;
            }
            if (count > 0) {
                std::uint32_t* const pixels =
                    picture.pixels.data() + static_cast<std::ptrdiff_t>(y) * picture.width + x;
                taker.take(picture.from->key, picture.to->key, x, y, pixels, count);
                if (is_shaded) draw_shaded(shape, taker, picture, x, y, pixels, count);
                if (picture.dimmed != nullptr) bend::dim(*picture.dimmed, pixels, count);
            }
            x += std::max(count, 1);
        }
    }
}

[[gnu::always_inline]] inline void bend_all(std::span<const SurfaceCorner> corners,
                                            std::span<const Corners> triangles, const BentPicture& picture) {
    Reach reach(picture.size());
    Shape<kSurfaceValues> shape;
    for (const Corners& numbers : triangles) {
        shape.corners = {&corners[numbers[0]], &corners[numbers[1]], &corners[numbers[2]], nullptr};
        const float area =
            shapes::area_of(shape.corners[0]->at_px, shape.corners[1]->at_px, shape.corners[2]->at_px);
        // Those that look away from the eye go clockwise.
        if (area > -kNoArea || shape.corners[0]->away_mm <= 0.0F || shape.corners[1]->away_mm <= 0.0F ||
            shape.corners[2]->away_mm <= 0.0F)
            continue;
        shapes::find_slopes(shape, area);
        shapes::find_reach(shape, false, picture.size(), reach);
        draw(shape, picture, reach);
    }
}

void relief_plain(std::span<const ReliefCorner> corners, std::span<const Quad> quads,
                  const BentPicture& picture) {
    bend_all(corners, quads, picture);
}
void surface_plain(std::span<const SurfaceCorner> corners, std::span<const Corners> triangles,
                   const BentPicture& picture) {
    bend_all(corners, triangles, picture);
}

ONGGI_WIDE_VECTORS void relief_wide(std::span<const ReliefCorner> corners, std::span<const Quad> quads,
                                    const BentPicture& picture) {
    bend_all(corners, quads, picture);
}
ONGGI_WIDE_VECTORS void surface_wide(std::span<const SurfaceCorner> corners,
                                     std::span<const Corners> triangles, const BentPicture& picture) {
    bend_all(corners, triangles, picture);
}

}  // namespace

void bend_relief(std::span<const ReliefCorner> corners, std::span<const Quad> quads,
                 const BentPicture& picture) {
    static auto* const best = best_of(relief_plain, relief_wide);
    best(corners, quads, picture);
}

void bend_surface(std::span<const SurfaceCorner> corners, std::span<const Corners> triangles,
                  const BentPicture& picture) {
    static auto* const best = best_of(surface_plain, surface_wide);
    best(corners, triangles, picture);
}

}  // namespace onggi::render

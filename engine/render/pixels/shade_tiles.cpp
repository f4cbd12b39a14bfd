#include "engine/render/pixels/shade_tiles.h"

#include <algorithm>
#include <cstdlib>

namespace onggi::render {
namespace {

constexpr int kAcross = shaders::kMaskTexels;

struct Texel {
    int u;
    int v;
};
Texel texel_of(std::uint32_t place) {
    const int number = static_cast<int>(place >> 16U);
    return {number % kAcross, number / kAcross};
}

// The mask's border is never in shade, and everything outside the mask is mapped to it.
bool is_border(const Texel& at) {
    return at.u == 0 || at.v == 0 || at.u >= kAcross - 2 || at.v >= kAcross - 2;
}

// Neighbouring pixels of one surface have mask texels close to each other, mostly in the same or the next row
// of texels.
constexpr int kFarTexels = 3;
[[gnu::always_inline]] inline unsigned may_be_another_thing(std::uint32_t place, std::uint32_t next) {
    const int apart = std::abs(static_cast<int>(place >> 16U) - static_cast<int>(next >> 16U));
    const unsigned is_far = apart >= kFarTexels ? 1U : 0U;
    return std::abs(apart - kAcross) >= kFarTexels ? is_far : 0U;
}

bool is_another_thing(std::uint32_t place, std::uint32_t next) {
    if (may_be_another_thing(place, next) == 0) return false;
    const Texel a = texel_of(place);
    const Texel b = texel_of(next);
    if (is_border(a) && is_border(b)) return false;
    return std::abs(a.u - b.u) >= kFarTexels || std::abs(a.v - b.v) >= kFarTexels;
}

// Returns for each pixel whether it may be at a silhouette. The compiler vectorises the loops.
std::vector<std::uint8_t> look_roughly(std::size_t width, std::span<const std::uint32_t> places) {
    if (places.size() <= width) return std::vector<std::uint8_t>(places.size(), 0);
    const std::size_t count = places.size() - width;
    std::vector<std::uint8_t> before(places.size(), 0);  // whether the pixel to the right or below differs
    for (std::size_t i = 0; i < count; ++i) {
        before[i] = static_cast<std::uint8_t>(may_be_another_thing(places[i], places[i + 1]) |
                                              may_be_another_thing(places[i], places[i + width]));
    }
    std::vector<std::uint8_t> may_be = before;
    for (std::size_t i = width; i < places.size(); ++i)
        may_be[i] = static_cast<std::uint8_t>(before[i] | before[i - 1] | before[i - width]);
    return may_be;
}

// The range of the key light at some texels, of 255.
int apart(const ShadowMask& mask, const std::array<std::uint16_t, 3>& texels) {
    std::array<int, 3> keys{};
    std::transform(texels.begin(), texels.end(), keys.begin(),
                   [&](std::uint16_t texel) { return static_cast<int>(mask[texel] & 0xFFFFU); });
    const auto [least, most] = std::minmax_element(keys.begin(), keys.end());
    return *most - *least;
}

std::uint32_t two_thirds_and_one(std::uint32_t inner, std::uint32_t outer) {
    std::uint32_t mixed = 0;
    for (std::uint32_t shift = 0; shift < 32U; shift += 8U)
        mixed |= (2U * (inner >> shift & 0xFFU) + (outer >> shift & 0xFFU) + 1U) / 3U << shift;
    return mixed;
}

}  // namespace

void ShadeEdges::find_at(int x, int y, std::span<const std::uint32_t> places) {
    const auto at = [&](int column, int row) {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(column);
    };
    const auto differ = [&](int column, int row, int right, int down) {
        return is_another_thing(places[at(column, row)], places[at(column + right, row + down)]);
    };
    // At a mostly horizontal silhouette the two sides are above and below.
    int level = 0;
    int upright = 0;
    for (int off = -2; off <= 2; ++off) {
        level += (differ(x + off, y, 0, -1) ? 1 : 0) + (differ(x + off, y, 0, 1) ? 1 : 0);
        upright += (differ(x, y + off, -1, 0) ? 1 : 0) + (differ(x, y + off, 1, 0) ? 1 : 0);
    }
    const int right = level >= upright ? 0 : 1;
    const int down = 1 - right;
    const bool is_after = differ(x, y, -right, -down);
    if (!is_after && !differ(x, y, right, down)) return;
    const int way = is_after ? -1 : 1;
    const std::size_t pixel = at(x, y);
    const std::size_t inner = at(x - way * right, y - way * down);
    const std::size_t outer = at(x + 2 * way * right, y + 2 * way * down);
    const auto texel = [&](std::size_t of) { return static_cast<std::uint16_t>(places[of] >> 16U); };
    edges_.push_back({static_cast<std::uint32_t>(pixel),
                      static_cast<std::uint32_t>(inner),
                      static_cast<std::uint32_t>(outer),
                      {texel(pixel), texel(inner), texel(outer)}});
}

void ShadeEdges::find(int width, std::span<const std::uint32_t> places) {
    constexpr int kReach = 3;  // neighbourhood that find_at() reads
    edges_.clear();
    row_begins_.assign(1, 0);
    width_ = width;
    const int height = static_cast<int>(places.size()) / std::max(width, 1);
    if (height == 0) return;
    const std::vector<std::uint8_t> may_be = look_roughly(static_cast<std::size_t>(width), places);
    for (int y = 0; y < height; ++y) {
        if (y >= kReach && y + kReach < height) {
            const std::uint8_t* const row = may_be.data() + static_cast<std::ptrdiff_t>(y) * width_;
            for (int x = kReach; x + kReach < width_; ++x) {
                if (row[x] != 0) find_at(x, y, places);
            }
        }
        row_begins_.push_back(edges_.size());
    }
}

void ShadeEdges::smooth(const ShadowMask& mask, std::span<const PixelRect> rects,
                        std::span<std::uint32_t> picture) {
    constexpr int kAlike = 16;
    if (edges_.empty()) return;
    const auto edge_at = [&](std::size_t number) {
        return edges_.begin() + static_cast<std::ptrdiff_t>(number);
    };
    mixed_.clear();
    for (const PixelRect& rect : rects) {
        for (int y = rect.y; y < rect.y + rect.height; ++y) {
            const auto row = static_cast<std::size_t>(y);
            const auto first = static_cast<std::uint32_t>(y * width_ + rect.x);
            const std::uint32_t end = first + static_cast<std::uint32_t>(rect.width);
            const auto last = edge_at(row_begins_[row + 1]);
            auto edge = std::lower_bound(edge_at(row_begins_[row]), last, first,
                                         [](const Edge& a, std::uint32_t pixel) { return a.pixel < pixel; });
            for (; edge != last && edge->pixel < end; ++edge) {
                if (apart(mask, edge->texels) < kAlike) continue;
                mixed_.push_back(
                    {edge->pixel, two_thirds_and_one(picture[edge->inner], picture[edge->outer])});
            }
        }
    }
    for (const Mixed& mixed : mixed_)
        picture[mixed.pixel] = mixed.colour;
}

namespace {

constexpr std::size_t kTexelsAcross = shaders::kMaskTexels;
constexpr std::size_t kSums = kTexelsAcross + 1;

}  // namespace

void ShadeTiles::Reach::hold(std::span<const std::uint32_t> places) {
    // Division by multiplication, which vectorises; the shift is wide enough for every texel index.
    constexpr int kShift = 22;
    constexpr int kOneOver = (1 << kShift) / int{kTexelsAcross} + 1;
    int least_u = left;
    int most_u = right - 1;
    int least_v = top;
    int most_v = bottom - 1;
    for (const std::uint32_t place : places) {
        const int texel = static_cast<int>(place >> 16U);
        const int v = texel * kOneOver >> kShift;
        const int u = texel - v * int{kTexelsAcross};
        least_u = std::min(least_u, u);
        most_u = std::max(most_u, u);
        least_v = std::min(least_v, v);
        most_v = std::max(most_v, v);
    }
    // A place lies between a texel and the next, in both directions.
    left = static_cast<std::uint8_t>(least_u);
    right = static_cast<std::uint8_t>(most_u + 1);
    top = static_cast<std::uint8_t>(least_v);
    bottom = static_cast<std::uint8_t>(most_v + 1);
}

void ShadeTiles::learn(const TileGrid& grid, std::span<const std::uint32_t> places) {
    grid_ = grid;
    reach_.assign(grid.count(), {});
    is_stale_.assign(grid.count(), 1);
    may_wait_.assign(grid.count(), 0);
    numbers_.assign(grid.count(), 0);
    const auto width = static_cast<std::size_t>(grid.width_px);
    const auto across = static_cast<std::size_t>(grid.across());
    for (std::size_t y = 0; y < static_cast<std::size_t>(grid.height_px); ++y) {
        Reach* const row = &reach_[y / kTileHeightPx * across];
        for (std::size_t tile = 0; tile < across; ++tile) {
            const std::size_t first = tile * kTileWidthPx;
            row[tile].hold(
                places.subspan(y * width + first, std::min<std::size_t>(kTileWidthPx, width - first)));
        }
    }
}

void ShadeTiles::note_mask(const ShadowMask& before, const ShadowMask& now) {
    // Summed-area table of changed texels, so that each tile's reach costs four lookups.
    changed_above_left_.assign(kSums * kSums, 0);
    for (std::size_t v = 0; v < kTexelsAcross; ++v) {
        std::uint16_t in_row = 0;
        for (std::size_t u = 0; u < kTexelsAcross; ++u) {
            in_row = static_cast<std::uint16_t>(
                in_row + (before[v * kTexelsAcross + u] != now[v * kTexelsAcross + u]));
            changed_above_left_[(v + 1) * kSums + u + 1] =
                static_cast<std::uint16_t>(changed_above_left_[v * kSums + u + 1] + in_row);
        }
    }
    if (changed_above_left_.back() == 0) return;
    const auto sum = [&](std::size_t u, std::size_t v) { return int{changed_above_left_[v * kSums + u]}; };
    for (std::size_t tile = 0; tile < reach_.size(); ++tile) {
        const Reach& reach = reach_[tile];
        const std::size_t right = std::size_t{reach.right} + 1;
        const std::size_t bottom = std::size_t{reach.bottom} + 1;
        const int changed =
            sum(right, bottom) - sum(reach.left, bottom) - sum(right, reach.top) + sum(reach.left, reach.top);
        if (changed > 0) is_stale_[tile] = 1;
    }
}

void ShadeTiles::note_light(LightChange change) {
    std::vector<std::uint8_t>& noted = change == LightChange::kLittle ? may_wait_ : is_stale_;
    std::fill(noted.begin(), noted.end(), std::uint8_t{1});
}

void ShadeTiles::take(std::uint64_t number, std::vector<PixelRect>& rects) {
    waiting_rows_ = 1 - waiting_rows_;
    is_due_ = is_stale_;
    for (std::size_t tile = 0; tile < is_due_.size(); ++tile) {
        const int row = static_cast<int>(tile) / grid_.across();
        if (may_wait_[tile] != 0 && row % 2 != waiting_rows_) is_due_[tile] = 1;
        if (is_due_[tile] == 0) continue;
        is_stale_[tile] = 0;
        may_wait_[tile] = 0;
        numbers_[tile] = number;
    }
    rects_of_tiles(grid_, is_due_, rects);
}

}  // namespace onggi::render

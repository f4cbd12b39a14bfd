#include "engine/render/pixels/shade_tiles.h"

#include <algorithm>
#include <cstddef>

namespace onggi::render {
namespace {

constexpr std::size_t kTexelsAcross = shaders::kMaskTexels;
constexpr std::size_t kSums = kTexelsAcross + 1;

}  // namespace

void ShadeTiles::Reach::hold(std::span<const std::uint32_t> places) {
    // Vectors divide by multiplying; so wide that no texel's number is too large.
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
    // A place lies between a texel and the next, both ways.
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
    // Sums over all texels above and to the left, so that a tile's reach costs four of them.
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

void ShadeTiles::take(std::span<const std::uint8_t> moving, std::uint64_t number,
                      std::vector<PixelRect>& rects) {
    waiting_rows_ = 1 - waiting_rows_;
    is_due_ = is_stale_;
    for (std::size_t tile = 0; tile < is_due_.size(); ++tile) {
        const int row = static_cast<int>(tile) / grid_.across();
        if (may_wait_[tile] != 0 && row % 2 != waiting_rows_) is_due_[tile] = 1;
        if (!moving.empty() && moving[tile] == kCovered) is_due_[tile] = 0;
        if (is_due_[tile] == 0) continue;
        is_stale_[tile] = 0;
        may_wait_[tile] = 0;
        numbers_[tile] = number;
    }
    rects_of_tiles(grid_, is_due_, rects);
}

}  // namespace onggi::render

// Bands of a large picture's rows, which a second thread shares with the main thread; a small picture is one
// band, drawn by the main thread alone. Main thread. Pixels.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "engine/jobs/shared_loop.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/pixels/picture_shapes.h"
#include "engine/render/shapes/tiles.h"

namespace onggi::render {

// Several times the height of a triangle, so that few are drawn in two bands; small enough for both threads
// to end at about the same time. A multiple of a tile's height.
constexpr int kBandRows = 64;

// The number of bands: one if there is no second thread, or if one core draws such a picture in time.
[[nodiscard]] inline int band_count(const FrameContext& frame) {
    constexpr std::size_t kLargePx = std::size_t{2560} * 1440;
    const jobs::SharedLoop* const loop = frame.desc.loop;
    const bool is_large = std::size_t{frame.extent.width} * frame.extent.height >= kLargePx;
    if (!is_large || loop == nullptr || !loop->is_shared()) return 1;
    return (static_cast<int>(frame.extent.height) + kBandRows - 1) / kBandRows;
}

// Calls work(number, rows) for each band, on either thread; returns when all bands are done.
template <typename Work>
void for_bands(const FrameContext& frame, Work&& work) {
    const int height = static_cast<int>(frame.extent.height);
    const int count = band_count(frame);
    if (count == 1) return work(0, RowSpan{0, height});
    frame.desc.loop->run(count, [&](int band) {
        work(band, RowSpan{band * kBandRows, std::min((band + 1) * kBandRows, height)});
    });
}

// Calls add(band, first) for each band that a triangle may touch; `first`: of its three indices. Triangles
// that cover no line's centre, or have a corner behind the eye, are left out: nobody draws them.
template <typename Corner, typename Index, typename Add>
void for_bands_of_triangles(std::span<const Corner> corners, std::span<const Index> indices, int height_px,
                            Add add) {
    for (std::size_t first = 0; first + 2 < indices.size(); first += 3) {
        const Corner& a = corners[indices[first]];
        const Corner& b = corners[indices[first + 1]];
        const Corner& c = corners[indices[first + 2]];
        if (std::min({a.away_mm, b.away_mm, c.away_mm}) <= 0.0F) continue;
        const int top = shapes::first_pixel(std::min({a.at_px.y, b.at_px.y, c.at_px.y}), height_px);
        const int end = shapes::first_pixel(std::max({a.at_px.y, b.at_px.y, c.at_px.y}), height_px);
        if (top >= end) continue;
        for (int band = top / kBandRows; band <= (end - 1) / kBandRows; ++band)
            add(static_cast<std::size_t>(band), first);
    }
}

}  // namespace onggi::render

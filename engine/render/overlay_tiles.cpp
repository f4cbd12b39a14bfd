#include "engine/render/overlay_tiles.h"

#include <algorithm>
#include <cstddef>

#include "engine/core/hash.h"

namespace onggi::render {
namespace {

PixelRect rect_of(std::span<const ui::Vertex> vertices, std::span<const std::uint32_t> corners) {
    vec2 low = vertices[corners[0]].position_px;
    vec2 high = low;
    for (const std::uint32_t corner : corners.subspan(1)) {
        low = glm::min(low, vertices[corner].position_px);
        high = glm::max(high, vertices[corner].position_px);
    }
    return rect_about(low, high);
}

bool touch(const PixelRect& a, const PixelRect& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

}  // namespace

void OverlayTiles::learn(const TileGrid& grid, const ui::DrawList& list, std::uint64_t list_hash,
                         std::uint64_t atlas_state) {
    const bool is_known = content_.size() == grid.count() && grid == grid_;
    if (is_known && list_hash == list_hash_ && atlas_state == atlas_state_) return;
    grid_ = grid;
    list_hash_ = list_hash;
    atlas_state_ = atlas_state;
    const std::span<const std::uint32_t> indices = list.indices();
    content_.assign(grid.count(), 0);
    rects_.clear();
    for (std::size_t at = 0; at < indices.size(); at += 3)
        rects_.push_back(rect_of(list.vertices(), indices.subspan(at, 3)));
    for (const ui::Run& run : list.runs()) {
        for (std::size_t at = run.first_index; at < std::size_t{run.first_index} + run.index_count; at += 3) {
            StateHash of_triangle;
            of_triangle.add_word(atlas_state);
            of_triangle.add_word(run.from_atlas ? 1 : 0);
            for (const std::uint32_t corner : indices.subspan(at, 3)) {
                static_assert(sizeof(ui::Vertex) == 2 * sizeof(vec2) + sizeof(std::uint32_t));
                of_triangle.add_bytes(std::as_bytes(list.vertices().subspan(corner, 1)));
            }
            for_tiles(grid, rects_[at / 3], [&](std::size_t tile) {
                StateHash number;
                number.add_word(content_[tile]);
                number.add_word(of_triangle.value());
                content_[tile] = std::max<std::uint64_t>(number.value(), 1);
            });
        }
    }
}

void OverlayTiles::take(const ui::DrawList& list, std::span<const std::uint8_t> wanted,
                        std::vector<std::uint32_t>& indices, std::vector<ClippedRun>& runs) {
    indices.clear();
    runs.clear();
    rects_of_tiles(grid_, wanted, wanted_);
    for (const PixelRect& inside : wanted_) {
        for (const ui::Run& run : list.runs()) {
            const auto begin = static_cast<std::uint32_t>(indices.size());
            for (std::size_t at = run.first_index; at < std::size_t{run.first_index} + run.index_count;
                 at += 3) {
                if (!touch(rects_[at / 3], inside)) continue;
                const std::span<const std::uint32_t> corners = list.indices().subspan(at, 3);
                indices.insert(indices.end(), corners.begin(), corners.end());
            }
            const auto count = static_cast<std::uint32_t>(indices.size()) - begin;
            if (count > 0) runs.push_back({inside, {run.from_atlas, begin, count}});
        }
    }
}

}  // namespace onggi::render

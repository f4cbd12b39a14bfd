#include "engine/render/pixels/overlay_tiles.h"

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

}  // namespace

void OverlayTiles::learn(const TileGrid& grid, const ui::DrawList& list, const OverlayPictures& pictures) {
    const bool is_known = content_.size() == grid.count() && grid == grid_;
    const std::uint64_t list_hash = list.hash();
    if (is_known && list_hash == list_hash_ && pictures.state() == pictures_state_) return;
    grid_ = grid;
    list_hash_ = list_hash;
    pictures_state_ = pictures.state();
    content_.assign(grid.count(), 0);
    for (const ui::Run& run : list.runs()) {
        const std::span<const std::uint32_t> indices =
            list.indices().subspan(run.first_index, run.index_count);
        for (std::size_t at = 0; at < indices.size(); at += 3) {
            const std::span<const std::uint32_t> corners = indices.subspan(at, 3);
            StateHash of_triangle;
            of_triangle.add_word(run.from_atlas ? 1 : 0);
            if (run.from_atlas) {
                const auto* picture = pictures.at(list.vertices()[corners[0]].atlas_px);
                of_triangle.add_word(picture == nullptr ? 0 : picture->number);
            }
            for (const std::uint32_t corner : corners) {
                static_assert(sizeof(ui::Vertex) == 2 * sizeof(vec2) + sizeof(std::uint32_t));
                of_triangle.add_bytes(std::as_bytes(list.vertices().subspan(corner, 1)));
            }
            for_tiles(grid, rect_of(list.vertices(), corners), [&](std::size_t tile) {
                StateHash number;
                number.add_word(content_[tile]);
                number.add_word(of_triangle.value());
                content_[tile] = std::max<std::uint64_t>(number.value(), 1);
            });
        }
    }
}

}  // namespace onggi::render

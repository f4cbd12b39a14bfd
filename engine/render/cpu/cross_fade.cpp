#include "engine/render/cpu/cross_fade.h"

#include "engine/render/pixels/mix_pixels.h"

namespace onggi::render {

void CrossFade::begin(const TileGrid& grid, const HostPicture& last, const KeptView::Lent& lent) {
    grid_ = grid;
    before_ = &lent.first;
    mixed_ = &lent.second;
    for_parts(last, grid_, wanted_, rects_, [&](const vk::Buffer& part, const PixelRect& rect) {
        if (&part == before_) return;
        copy_rect(part.as<const std::uint32_t>(), rect, static_cast<std::size_t>(grid_.width_px),
                  before_->as<std::uint32_t>());
    });
}

void CrossFade::mix(const HostPicture& now, float fraction, TileNumbers& numbers) {
    const auto before = before_->as<const std::uint32_t>();
    const auto into = mixed_->as<std::uint32_t>();
    for_parts(now, grid_, wanted_, rects_, [&](const vk::Buffer& part, const PixelRect& rect) {
        mix_pixels(before, part.as<const std::uint32_t>(), fraction, rect, grid_.width_px, into);
    });
    numbers_.assign(grid_.count(), numbers.next());
}

}  // namespace onggi::render

#include "engine/render/cached/cross_fade.h"

#include <algorithm>
#include <utility>

#include "engine/render/pixels/mix_pixels.h"

namespace onggi::render {

Result<void> CrossFade::begin(const FrameContext& frame, const HostPicture& last) {
    grid_ = {static_cast<int>(frame.extent.width), static_cast<int>(frame.extent.height)};
    const auto make = [&](const char* name) {
        return vk::Buffer::create(frame.device,
                                  {.name = name,
                                   .size = VkDeviceSize{4} * frame.extent.width * frame.extent.height,
                                   .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT});
    };
    auto before = make("picture of the view before");
    if (!before) return before.error();
    copy_whole(last, grid_, before->as<std::uint32_t>());
    if (!is_on()) {
        auto mixed = make("two views mixed");
        if (!mixed) return mixed.error();
        mixed_ = std::move(*mixed);
    }
    before_ = std::move(*before);
    return {};
}

void CrossFade::end() {
    before_ = {};
    mixed_ = {};
}

void CrossFade::mix(const HostPicture& now, float share, TileNumbers& numbers) {
    const auto before = before_.as<const std::uint32_t>();
    const auto into = mixed_.as<std::uint32_t>();
    for_parts(now, grid_, wanted_, rects_, [&](const vk::Buffer& part, const PixelRect& rect) {
        mix_pixels(before, part.as<const std::uint32_t>(), share, rect, grid_.width_px, into);
    });
    numbers_.assign(grid_.count(), numbers.next());
}

}  // namespace onggi::render

#include "game/wheel/still.h"

#include <fmt/format.h>

#include "engine/render/renderer.h"
#include "engine/vk/offscreen.h"
#include "game/wheel/wheel_scene.h"

namespace onggi::wheel {

Result<asset::Image> render_still(const PotView& pot, int width, int height, const StillOptions& options) {
    constexpr int kLeast = 16;
    constexpr int kMost = 8192;
    if (width < kLeast || height < kLeast || width > kMost || height > kMost) {
        return bad_input(fmt::format("picture size: expected {0} to {1} pixels each way, found {2}x{3}",
                                     kLeast, kMost, width, height));
    }
    auto instance = vk::Instance::create({.validation = options.validation});
    if (!instance) return instance.error();
    auto chosen = vk::choose_device(**instance, VK_NULL_HANDLE);
    if (!chosen) return chosen.error();
    asset::Image image{.width = width, .height = height, .rgba = {}};
    {
        auto device = vk::Device::create(**instance, *chosen, false);
        if (!device) return device.error();
        auto target = vk::Offscreen::create(
            **device, {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)});
        if (!target) return target.error();
        auto renderer = render::Renderer::create(**device, render::still_desc((*target)->format()));
        if (!renderer) return renderer.error();
        WheelScene scene;
        auto drawn = (*renderer)->draw(scene.apply(pot, width, height), **target);
        if (!drawn) return drawn.error();
        auto pixels = (*target)->read_back();
        if (!pixels) return pixels.error();
        image.rgba = std::move(*pixels);
    }
    // The device is gone: what it was late to complain of has been heard too.
    const std::vector<std::string>& messages = (*instance)->messages();
    if (!messages.empty()) {
        return failed(fmt::format("Vulkan validation: expected no message, found {}, the first: {}",
                                  messages.size(), messages.front()));
    }
    return image;
}

}  // namespace onggi::wheel

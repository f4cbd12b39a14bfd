#include "game/wheel/still.h"

#include <fmt/format.h>

#include "engine/render/beauty.h"
#include "engine/render/renderer.h"
#include "engine/vk/offscreen.h"
#include "game/wheel/workshop_scene.h"

namespace onggi::wheel {
namespace {

// Turns the scene to the view, and says what of the pot's surroundings it shows.
PotView set_view(WheelScene& scene, PotView pot, StillView view) {
    scene.look_at(view == StillView::kLookingIn ? View::kLookingIn : View::kThrowing);
    Clay& clay = scene.registry().get<Clay>(scene.clay());
    clay.is_cut_open = clay.shows_load = view == StillView::kCutaway;
    if (view == StillView::kPortrait || view == StillView::kCutaway) {
        pot.hand.shown = pot.second_hand.shown = false;
        pot.wire_shown = false;
    }
    return pot;
}

}  // namespace

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
        const OpenedScene opened = open_scene(options.workshop, width, height);
        const PotView shown = set_view(*opened.scene, pot, options.view);
        const render::Scene& seen = opened.scene->apply(shown, width, height);
        const auto picture = [&](const render::Scene& scene) -> Result<std::vector<std::uint8_t>> {
            auto drawn = (*renderer)->draw(scene, **target);
            if (!drawn) return drawn.error();
            return (*target)->read_back();
        };
        if (options.beauty) {
            render::Accumulation mean(width, height);
            for (int sample = 0; sample < kBeautySamples; ++sample) {
                auto pixels = picture(render::beauty_sample(seen, sample, width, height));
                if (!pixels) return pixels.error();
                mean.add(*pixels);
            }
            image = mean.mean();
        } else {
            auto pixels = picture(seen);
            if (!pixels) return pixels.error();
            image.rgba = std::move(*pixels);
        }
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

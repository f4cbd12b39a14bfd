#include "game/wheel/still.h"

#include <fmt/format.h>

#include "engine/render/beauty.h"
#include "engine/render/renderer.h"
#include "engine/vk/offscreen.h"
#include "game/wheel/section_labels.h"
#include "game/wheel/wheel_scene.h"

namespace onggi::wheel {
namespace {

// Sets the scene's view, and returns the snapshot without a cut of the wire where the view does not show it.
haptic::Snapshot set_view(WheelScene& scene, const haptic::Snapshot& snapshot, StillView view) {
    scene.look_at(view == StillView::kLookingIn ? View::kLookingIn : View::kThrowing);
    Clay& clay = scene.registry().get<Clay>(scene.clay());
    clay.is_cut_open = clay.shows_load = view == StillView::kCutaway;
    const bool shows_work = view == StillView::kThrowing || view == StillView::kLookingIn;
    scene.show_hands(shows_work);
    haptic::Snapshot shown = snapshot;
    if (!shows_work) shown.tool.wire = tool::Wire::kNone;
    return shown;
}

}  // namespace

struct StillCamera::Parts {
    int width = 0;
    int height = 0;
    int across = 1;
    bool beauty = false;
    std::unique_ptr<vk::Instance> instance;
    std::unique_ptr<vk::Device> device;
    std::unique_ptr<vk::Offscreen> target;
    std::unique_ptr<render::Renderer> renderer;
    OpenedScene opened;

    Result<std::vector<std::uint8_t>> draw(const render::Scene& scene) {
        auto drawn = renderer->draw(scene, *target);
        if (!drawn) return drawn.error();
        return target->read_back();
    }
    [[nodiscard]] Result<void> check_silence() const {
        const std::vector<std::string>& messages = instance->messages();
        if (messages.empty()) return {};
        return failed(fmt::format("Vulkan validation: expected no message, found {}, the first: {}",
                                  messages.size(), messages.front()));
    }
};

StillCamera::StillCamera() : parts_(std::make_unique<Parts>()) {}
StillCamera::~StillCamera() = default;

Result<std::unique_ptr<StillCamera>> StillCamera::create(int width, int height, const StillOptions& options) {
    constexpr int kLeast = 16;
    const int most = kMostStillPx / options.across;
    if (width < kLeast || height < kLeast || width > most || height > most) {
        return bad_input(fmt::format("picture size: expected {0} to {1} pixels each way, found {2}x{3}",
                                     kLeast, most, width, height));
    }
    std::unique_ptr<StillCamera> camera(new StillCamera);
    Parts& parts = *camera->parts_;
    parts.width = width;
    parts.height = height;
    parts.across = options.across;
    parts.beauty = options.beauty;
    const int drawn_width = width * options.across;
    const int drawn_height = height * options.across;
    auto drawn_by = vk::OffscreenDevice::open({.validation = options.validation});
    if (!drawn_by) return drawn_by.error();
    parts.instance = std::move(drawn_by->instance);
    parts.device = std::move(drawn_by->device);
    auto target = vk::Offscreen::create(
        *parts.device, {static_cast<std::uint32_t>(drawn_width), static_cast<std::uint32_t>(drawn_height)});
    if (!target) return target.error();
    parts.target = std::move(*target);
    constexpr bool kOnProcessor = true;
    const render::RendererDesc desc =
        options.quick ? render::live_desc(parts.target->format(), kOnProcessor, drawn_height)
                      : render::still_desc(parts.target->format());
    auto renderer = render::Renderer::create(*parts.device, desc);
    if (!renderer) return renderer.error();
    parts.renderer = std::move(*renderer);
    parts.opened = open_scene(options.workshop, drawn_width, drawn_height);
    return camera;
}

void StillCamera::forget() {
    parts_->opened.scene->forget_hands();
}

WheelScene& StillCamera::scene() {
    return *parts_->opened.scene;
}

Result<asset::Image> StillCamera::take(const haptic::Snapshot& snapshot, StillView view) {
    Parts& parts = *parts_;
    asset::Image image{.width = parts.width, .height = parts.height, .rgba = {}};
    const haptic::Snapshot shown = set_view(scene(), snapshot, view);
    const int drawn_width = parts.width * parts.across;
    const int drawn_height = parts.height * parts.across;
    const render::Scene& seen = scene().apply(shown, drawn_width, drawn_height);
    if (parts.beauty || parts.across > 1) {
        render::Accumulation mean(parts.width, parts.height, parts.across);
        for (int sample = 0; sample < (parts.beauty ? kBeautySamples : 1); ++sample) {
            auto pixels = parts.draw(
                parts.beauty ? render::beauty_sample(seen, sample, drawn_width, drawn_height) : seen);
            if (!pixels) return pixels.error();
            mean.add(*pixels);
        }
        image = mean.mean();
    } else {
        auto pixels = parts.draw(seen);
        if (!pixels) return pixels.error();
        image.rgba = std::move(*pixels);
    }
    if (auto silent = parts.check_silence(); !silent) return silent.error();
    if (view == StillView::kCutaway) {
        ui::Painter painter;
        lay_over(image, painter.paint(section_labels(*scene().seen().pot, scene().seen().direction,
                                                     seen.camera, parts.width, parts.height, painter)));
    }
    return image;
}

Result<void> StillCamera::close() {
    parts_->renderer.reset();
    parts_->target.reset();
    parts_->device.reset();
    return parts_->check_silence();
}

Result<asset::Image> render_still(const haptic::Snapshot& snapshot, int width, int height,
                                  const StillOptions& options) {
    auto camera = StillCamera::create(width, height, options);
    if (!camera) return camera.error();
    auto image = (*camera)->take(snapshot, options.view);
    if (auto closed = (*camera)->close(); image && !closed) return closed.error();
    return image;
}

}  // namespace onggi::wheel

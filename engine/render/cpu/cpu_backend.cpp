#include "engine/render/cpu/cpu_backend.h"

#include <optional>
#include <utility>

#include "engine/render/frame/shadow_map.h"
#include "engine/render/shapes/moving_tiles.h"

namespace onggi::render {
namespace {

// What stands still in it, from the next view.
Scene seen_next(const Scene& scene) {
    Scene seen = scene;
    seen.camera = scene.next_view->camera;
    seen.background = scene.next_view->background;
    return seen;
}

}  // namespace

Result<void> CpuBackend::create() {
    if (auto created = frame_.create(shaders::kBindingsOfLayers); !created) return created;
    if (auto made = create_pipelines(frame_, room_.pipelines); !made) return made;
    moving_.create(frame_.desc);
    return {};
}

void CpuBackend::fit_size(VkExtent2D target) {
    if (target.width == frame_.extent.width && target.height == frame_.extent.height) return;
    frame_.extent = target;
    resting_.forget();
    fade_.end();
    shown_.forget();
    next_.forget();
    has_picture_ = false;
}

Result<void> CpuBackend::fit(const Scene& scene, VkExtent2D target) {
    fit_size(target);
    if (!scene.background) {
        if (auto fitted = fit_shadow_map(frame_); !fitted) return fitted;
    }
    if (auto made = fit_pipelines(frame_, scene, room_.pipelines); !made) return made;
    if (auto fitted = room_.backgrounds.fit(frame_, scene); !fitted) return fitted;
    const auto is_another = room_.meshes.fit(frame_.device, scene.still_life);
    if (!is_another) return is_another.error();
    if (*is_another) {
        shown_.forget();
        next_.forget();
    }
    return {};
}

CpuBackend::Under CpuBackend::look_under(const Scene& scene, const Overlay* overlay) {
    const bool covers = overlay != nullptr && overlay->covers;
    will_rest_ = overlay != nullptr && overlay->scene_rests;
    if (!will_rest_) {
        resting_.forget();
        if (!covers) return Under::kScene;
        // Whether the next frame of it takes no longer than any other.
        return shown_.shows(frame_, scene) ? Under::kNothing : Under::kCoveredScene;
    }
    if (covers) return resting_.is_here() ? Under::kNothing : Under::kCoveredScene;
    return resting_.is_here() ? Under::kRestingScene : Under::kScene;
}

Result<bool> CpuBackend::draw(const Scene& scene, const vk::TargetImage& target, const Overlay* overlay) {
    const Under under = look_under(scene, overlay);
    std::optional<HostPicture> picture;
    if (under == Under::kScene || under == Under::kCoveredScene) {
        auto made = make(scene);
        if (!made) return made.error();
        picture.emplace(*made);
        if (will_rest_) {
            if (auto kept = resting_.keep(frame_, *picture, numbers_); !kept) return kept.error();
        }
    } else if (under == Under::kNothing) {
        // Nobody sees how long the next view takes.
        frame_.stats.next_view_ready = scene.next_view.has_value();
        fade_.end();
        next_.let_go();
    }
    if (auto fitted = overlay_.fit(frame_, overlay); !fitted) return fitted.error();
    if (auto begun = frame_.begin(); !begun) return begun.error();
    frame_.enter("copies");
    if (under == Under::kScene || under == Under::kRestingScene) {
        const HostPicture& shown = under == Under::kScene ? *picture : resting_.picture();
        if (auto brought = bringing_.record(frame_, target, shown, overlay_); !brought)
            return brought.error();
    } else {
        bringing_.record_covered(frame_, target, overlay_);
    }
    if (auto ended = frame_.end(target); !ended) return ended.error();
    return under == Under::kScene;
}

// As a view alone has it. What moves lies where it did when it was drawn.
HostPicture CpuBackend::picture_of(const KeptView& view) const {
    return {.pixels = view.shaded(),
            .numbers = view.numbers(),
            .instead = &moving_.picture(),
            .instead_on = frame_.built.moving_tiles};
}

HostPicture CpuBackend::picture() const {
    return fade_.is_on() ? fade_.picture() : picture_of(shown_);
}

void CpuBackend::change_view(const Scene& scene) {
    if (!scene.fade_in) fade_.end();
    if (shown_.shows(frame_, scene)) return;
    const bool is_made = next_.shows(frame_, scene);
    if (is_made) std::swap(shown_, next_);
    if (!scene.fade_in || !has_picture_) return;
    const HostPicture last = fade_.is_on() ? fade_.picture() : picture_of(is_made ? next_ : shown_);
    const TileGrid grid{static_cast<int>(frame_.extent.width), static_cast<int>(frame_.extent.height)};
    fade_.begin(grid, last, next_.lend());
}

Result<void> CpuBackend::make_next_view(const Scene& scene) {
    if (fade_.is_on()) return {};  // in its memory
    const Scene seen = seen_next(scene);
    if (!next_.shows(frame_, seen)) {
        if (auto made = next_.make_part(frame_, seen, scene, room_, numbers_); !made) return made;
    }
    frame_.stats.next_view_ready = next_.shows(frame_, seen);
    return {};
}

Result<HostPicture> CpuBackend::make(const Scene& scene) {
    change_view(scene);
    frame_.clock.enter_host("shapes");
    frame_.build(scene, room_.meshes.bounds());
    models_.choose(scene, frame_.desc, frame_.view(scene), frame_.built);
    moving_.place(frame_, scene, models_);
    find_moving_tiles(scene, frame_.view(scene), frame_.built);
    frame_.clock.enter_host("room");
    // It may be seen from another place in any frame, and then there is no time to make room.
    if (scene.background) {
        if (auto fitted = next_.fit(frame_); !fitted) return fitted.error();
    }
    if (auto made = shown_.make(frame_, scene, room_, numbers_); !made) return made.error();
    frame_.stats.shadow_drawn = shown_.shade(frame_, scene, numbers_);
    frame_.clock.enter_host("hands and lathe");
    auto drawn = moving_.draw_over(frame_, shown_.shaded().as<const std::uint32_t>(), shown_.depth());
    if (!drawn) return drawn.error();
    if (scene.next_view) {
        frame_.clock.enter_host("next view");
        if (auto made = make_next_view(scene); !made) return made.error();
    }
    if (fade_.is_on()) {
        frame_.clock.enter_host("fade");
        fade_.mix(picture_of(shown_), *scene.fade_in, numbers_);
    }
    frame_.clock.end_host();
    has_picture_ = true;
    return picture();
}

}  // namespace onggi::render

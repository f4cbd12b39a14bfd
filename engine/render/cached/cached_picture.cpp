#include "engine/render/cached/cached_picture.h"

#include <optional>
#include <utility>

#include "engine/render/shapes/moving_tiles.h"

namespace onggi::render {
namespace {

// What stands still in it, from the next view.
Scene seen_next(const Scene& scene) {
    Scene seen = scene;
    seen.camera = scene.next_view->camera;
    seen.plate = scene.next_view->plate;
    return seen;
}

}  // namespace

Result<void> CachedPicture::create(FrameContext& frame) {
    moving_.create(frame.desc);
    return {};
}

void CachedPicture::resized() {
    resting_.forget();
    fade_.end();
    shown_.forget();
    next_.forget();
    has_picture_ = false;
}

Result<void> CachedPicture::fit(FrameContext& frame, const Scene& scene) {
    if (auto fitted = room_.plates.fit(frame, scene); !fitted) return fitted;
    const auto is_another = room_.meshes.fit(frame.device, scene.still_life);
    if (!is_another) return is_another.error();
    if (*is_another) {
        shown_.forget();
        next_.forget();
    }
    return {};
}

CachedPicture::Under CachedPicture::look_under(const FrameContext& frame, const Scene& scene,
                                               const Overlay* overlay) {
    const bool covers = overlay != nullptr && overlay->covers;
    will_rest_ = overlay != nullptr && overlay->scene_rests;
    if (!will_rest_) {
        resting_.forget();
        if (!covers) return Under::kScene;
        // Whether the next frame of it takes no longer than any other.
        return shown_.shows(frame, scene) ? Under::kNothing : Under::kCoveredScene;
    }
    if (covers) return resting_.is_here() ? Under::kNothing : Under::kCoveredScene;
    return resting_.is_here() ? Under::kRestingScene : Under::kScene;
}

Result<bool> CachedPicture::draw(FrameContext& frame, const Scene& scene, const vk::TargetImage& target,
                                 const Overlay* overlay) {
    const Under under = look_under(frame, scene, overlay);
    std::optional<HostPicture> picture;
    if (under == Under::kScene || under == Under::kCoveredScene) {
        auto made = make(frame, scene);
        if (!made) return made.error();
        picture.emplace(*made);
        if (will_rest_) {
            if (auto kept = resting_.keep(frame, *picture, numbers_); !kept) return kept.error();
        }
    } else if (under == Under::kNothing) {
        // Nobody sees how long the next view takes.
        frame.stats.next_view_ready = scene.next_view.has_value();
        fade_.end();
        next_.let_go();
    }
    if (auto fitted = overlay_.fit(frame, overlay); !fitted) return fitted.error();
    if (auto begun = frame.begin(); !begun) return begun.error();
    frame.enter("copies");
    if (under == Under::kScene || under == Under::kRestingScene) {
        const HostPicture& shown = under == Under::kScene ? *picture : resting_.picture();
        if (auto brought = bringing_.record(frame, target, shown, overlay_); !brought) return brought.error();
    } else {
        bringing_.record_covered(frame, target, overlay_);
    }
    if (auto ended = frame.end(target); !ended) return ended.error();
    return under == Under::kScene;
}

// As a view alone has it. What moves lies where it did when it was drawn.
HostPicture CachedPicture::picture_of(const FrameContext& frame, const KeptView& view) const {
    return {.pixels = view.shaded(),
            .numbers = view.numbers(),
            .instead = &moving_.picture(),
            .instead_on = frame.built.moving_tiles};
}

HostPicture CachedPicture::picture(const FrameContext& frame) const {
    return fade_.is_on() ? fade_.picture() : picture_of(frame, shown_);
}

void CachedPicture::change_view(const FrameContext& frame, const Scene& scene) {
    if (!scene.fade_in) fade_.end();
    if (shown_.shows(frame, scene)) return;
    const bool is_made = next_.shows(frame, scene);
    if (is_made) std::swap(shown_, next_);
    if (!scene.fade_in || !has_picture_) return;
    const HostPicture last = fade_.is_on() ? fade_.picture() : picture_of(frame, is_made ? next_ : shown_);
    const TileGrid grid{static_cast<int>(frame.extent.width), static_cast<int>(frame.extent.height)};
    fade_.begin(grid, last, next_.lend());
}

Result<void> CachedPicture::make_next_view(FrameContext& frame, const Scene& scene) {
    if (fade_.is_on()) return {};  // in its memory
    const Scene seen = seen_next(scene);
    if (!next_.shows(frame, seen)) {
        if (auto made = next_.make_part(frame, seen, scene, room_, numbers_); !made) return made;
    }
    frame.stats.next_view_ready = next_.shows(frame, seen);
    return {};
}

Result<HostPicture> CachedPicture::make(FrameContext& frame, const Scene& scene) {
    change_view(frame, scene);
    frame.clock.enter_host("shapes");
    frame.build(scene, room_.meshes.bounds());
    models_.choose(scene, frame.desc, frame.view(scene), frame.built);
    moving_.place(frame, scene, models_);
    find_moving_tiles(scene, frame.view(scene), frame.built);
    frame.clock.enter_host("room");
    // It may be seen from another place in any frame, and then there is no time to make room.
    if (scene.plate) {
        if (auto fitted = next_.fit(frame); !fitted) return fitted.error();
    }
    if (auto made = shown_.make(frame, scene, room_, numbers_); !made) return made.error();
    frame.stats.shadow_drawn = shown_.shade(frame, scene, numbers_);
    frame.clock.enter_host("hands and clay");
    auto drawn = moving_.draw_over(frame, shown_.shaded().as<const std::uint32_t>(), shown_.depth());
    if (!drawn) return drawn.error();
    if (scene.next_view) {
        frame.clock.enter_host("next view");
        if (auto made = make_next_view(frame, scene); !made) return made.error();
    }
    if (fade_.is_on()) {
        frame.clock.enter_host("fade");
        fade_.mix(picture_of(frame, shown_), *scene.fade_in, numbers_);
    }
    frame.clock.end_host();
    has_picture_ = true;
    return picture(frame);
}

}  // namespace onggi::render

#include "engine/render/cached/cached_picture.h"

#include <optional>

#include "engine/render/shapes/moving_tiles.h"

namespace onggi::render {
namespace {

// Whether the processor bends the photographs; and otherwise shades the layers.
bool is_bent(const Scene& scene) {
    return scene.glide && scene.plate;
}

}  // namespace

Result<void> CachedPicture::create(FrameContext& frame) {
    moving_.create(frame.desc);
    return {};
}

CachedPicture::Under CachedPicture::look_under(const FrameContext& frame, const StillPass& room,
                                               const Scene& scene, const Overlay* overlay) {
    const bool covers = overlay != nullptr && overlay->covers;
    will_rest_ = overlay != nullptr && overlay->scene_rests;
    if (!will_rest_) {
        resting_.forget();
        if (!covers) return Under::kScene;
        // Whether the next frame of it takes no longer than any other.
        const bool is_prepared = is_bent(scene) || room.shows(frame, scene);
        return is_prepared ? Under::kNothing : Under::kCoveredScene;
    }
    if (covers) return resting_.is_here() ? Under::kNothing : Under::kCoveredScene;
    return resting_.is_here() ? Under::kRestingScene : Under::kScene;
}

Result<bool> CachedPicture::draw(FrameContext& frame, StillPass& room, const Scene& scene,
                                 const vk::TargetImage& target, const Overlay* overlay) {
    const Under under = look_under(frame, room, scene, overlay);
    std::optional<HostPicture> picture;
    if (under == Under::kScene || under == Under::kCoveredScene) {
        auto made = make(frame, room, scene);
        if (!made) return made.error();
        picture.emplace(*made);
        if (will_rest_) {
            if (auto kept = resting_.keep(frame, *picture); !kept) return kept.error();
        }
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

Result<HostPicture> CachedPicture::make(FrameContext& frame, StillPass& room, const Scene& scene) {
    frame.clock.enter_host("shapes");
    frame.build(scene, room.bounds());
    models_.choose(scene, frame.desc, frame.view(scene), frame.built);
    moving_.place(frame, scene, models_);
    find_moving_tiles(scene, frame.view(scene), frame.built);
    frame.clock.enter_host("room");
    room.update(frame, scene);
    auto made = is_bent(scene) ? make_bent(frame, room, scene) : make_standing(frame, room, scene);
    frame.clock.end_host();
    return made;
}

// The still life as it is under the moving things' shade.
Result<HostPicture> CachedPicture::make_standing(FrameContext& frame, StillPass& room, const Scene& scene) {
    glide_.rest();
    if (auto fitted = shade_.fit(frame); !fitted) return fitted.error();
    if (auto drawn = room.draw_layers(frame, scene); !drawn) return drawn.error();
    if (frame.stats.still_life_drawn) shade_.forget();
    shade_.shade(frame, scene, room.layers().layers());
    frame.clock.enter_host("hands and clay");
    auto drawn = moving_.draw_over(frame, shade_.shaded().as<const std::uint32_t>(),
                                   room.layers().depth().as<const float>());
    if (!drawn) return drawn.error();
    return HostPicture{.pixels = shade_.shaded(),
                       .numbers = shade_.tiles().numbers(),
                       .instead = &moving_.picture(),
                       .instead_on = frame.built.moving_tiles};
}

Result<HostPicture> CachedPicture::make_bent(FrameContext& frame, StillPass& room, const Scene& scene) {
    shade_.let_go();
    room.let_go_layers();
    if (auto bent = glide_.bend(frame, scene, room.plates()); !bent) return bent.error();
    frame.clock.enter_host("hands and clay");
    moving_.draw(frame, glide_.canvas());
    return glide_.picture();
}

}  // namespace onggi::render

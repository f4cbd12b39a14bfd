#include "engine/render/cpu/kept_view.h"

#include "engine/render/frame/shadow_map.h"
#include "engine/render/shapes/frame_build.h"

namespace onggi::render {
namespace {

std::uint64_t hash_of(const FrameContext& frame, const Scene& scene) {
    return still_hash(scene, static_cast<int>(frame.extent.width), static_cast<int>(frame.extent.height));
}

}  // namespace

bool KeptView::is_of(const FrameContext& frame, const Scene& scene) const {
    return background_ == scene.background && of_ == hash_of(frame, scene);
}

Result<void> KeptView::make_part(FrameContext& frame, const Scene& seen, const Scene& now,
                                 const KeptRoom& room, TileNumbers& numbers) {
    if (!is_of(frame, seen)) parts_made_ = 0;
    if (parts_made_ < kDrawn) {
        of_ = hash_of(frame, seen);
        background_ = seen.background;
        if (auto drawn = draw(frame, seen, room); !drawn) return drawn;
        parts_made_ = background_ ? parts_made_ + 1 : kDrawn;
    } else if (parts_made_ < kLearnt) {
        layers_.turn_into_places();
        shade_.learn(frame, layers_.layers());
        parts_made_ = kLearnt;
    } else {
        shade_.shade(frame, now, layers_.layers(), {}, numbers);
        parts_made_ = kShaded;
    }
    return {};
}

Result<void> KeptView::make(FrameContext& frame, const Scene& scene, const KeptRoom& room,
                            TileNumbers& numbers) {
    while (!shows(frame, scene)) {
        if (auto made = make_part(frame, scene, scene, room, numbers); !made) return made;
    }
    return {};
}

Result<void> KeptView::fit(const FrameContext& frame) {
    if (auto fitted = layers_.fit(frame); !fitted) return fitted;
    return shade_.fit(frame);
}

void KeptView::let_go() {
    forget();
    layers_.let_go();
    shade_.let_go();
}

KeptView::Lent KeptView::lend() {
    forget();
    return {shade_.shaded(), layers_.with_key()};
}

Result<void> KeptView::draw(FrameContext& frame, const Scene& seen, const KeptRoom& room) {
    if (auto fitted = fit(frame); !fitted) return fitted;
    const shaders::FrameData by_day =
        still_frame(seen, room.meshes.bounds(), static_cast<int>(frame.extent.width),
                    static_cast<int>(frame.extent.height));
    frame.upload_uniforms(by_day);
    frame.stats.still_life_drawn = true;
    if (background_) return draw_band(frame, room, by_day.background_window);
    if (auto mapped = frame.run_once([&] { record_shadow_map(frame, room.meshes); }); !mapped) return mapped;
    return layers_.draw_own(frame, room.pipelines, room.meshes);
}

Result<void> KeptView::draw_band(FrameContext& frame, const KeptRoom& room, vec4 window) {
    const int height = static_cast<int>(frame.extent.height);
    const RowSpan rows{parts_made_ * height / kBands, (parts_made_ + 1) * height / kBands};
    if (rows.first == rows.end) return {};
    const auto background = room.backgrounds.find(background_);
    if (!background) return background.error();
    if (auto drawn = layers_.draw_places(frame, room.pipelines, room.meshes, rows); !drawn) return drawn;
    layers_.lay(**background, window, rows);
    return {};
}

}  // namespace onggi::render

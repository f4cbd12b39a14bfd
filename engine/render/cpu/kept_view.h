// What stands still as one camera sees it: its layers, and the shade on them. Made at once, or in parts while
// another view is shown, none of which takes a frame's time. Main thread.
#pragma once

#include <cstdint>
#include <memory>

#include "engine/core/result.h"
#include "engine/render/cpu/host_backgrounds.h"
#include "engine/render/cpu/host_shade.h"
#include "engine/render/cpu/layer_pipelines.h"
#include "engine/render/cpu/still_layers.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/frame/still_meshes.h"

namespace onggi::render {

// What a view is made of.
struct KeptRoom {
    LayerPipelines pipelines;
    StillMeshes meshes;
    HostBackgrounds backgrounds;
};

class KeptView {
  public:
    // Whether all of it is there, as this scene's camera sees it.
    [[nodiscard]] bool shows(const FrameContext& frame, const Scene& scene) const {
        return is_whole() && is_of(frame, scene);
    }
    // Makes the next part, of as many as it takes; begins anew with another view than before. `seen` is the
    // scene from this view, `now` the one that the frame shows and `frame.built` is of: its light and its
    // shade are the same. The frame's uniforms are written over. The device is idle. Errors: the device's.
    Result<void> make_part(FrameContext& frame, const Scene& seen, const Scene& now, const KeptRoom& room,
                           TileNumbers& numbers);
    // All of it, if it is not there.
    Result<void> make(FrameContext& frame, const Scene& scene, const KeptRoom& room, TileNumbers& numbers);
    // What it is made of has changed.
    void forget() { parts_made_ = 0; }
    // Makes room for it, so that no part has to. The device is idle.
    Result<void> fit(const FrameContext& frame);
    // Nobody will look from there: gives back its memory. The device is idle.
    void let_go();
    // Of a view that is left: its memory for two pictures as large as the frame, until something is made of
    // it again. There is room for it. In the first is what was shaded last.
    struct Lent {
        const vk::Buffer& first;
        const vk::Buffer& second;
    };
    [[nodiscard]] Lent lend();

    // Lays the shade and the light of the hour over it; it is there. True: the shade is another than before.
    bool shade(const FrameContext& frame, const Scene& scene, TileNumbers& numbers) {
        return shade_.shade(frame, scene, layers_.layers(), frame.built.moving_tiles, numbers);
    }
    [[nodiscard]] const vk::Buffer& shaded() const { return shade_.shaded(); }
    [[nodiscard]] std::span<const std::uint64_t> numbers() const { return shade_.tiles().numbers(); }
    [[nodiscard]] std::span<const float> depth() const { return layers_.depth().as<const float>(); }

  private:
    static constexpr int kBands = 6;  // of a photographed room, that are drawn and laid one by one
    enum Part { kDrawn = kBands, kLearnt, kShaded };

    [[nodiscard]] bool is_whole() const { return parts_made_ == kShaded; }
    [[nodiscard]] bool is_of(const FrameContext& frame, const Scene& scene) const;
    Result<void> draw(FrameContext& frame, const Scene& seen, const KeptRoom& room);
    Result<void> draw_band(FrameContext& frame, const KeptRoom& room, vec4 window);

    int parts_made_ = 0;
    std::uint64_t of_ = 0;  // hash of what it shows
    std::shared_ptr<const Background> background_;
    StillLayers layers_;
    HostShade shade_;
};

}  // namespace onggi::render

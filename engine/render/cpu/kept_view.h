// What stands still as one camera sees it: its layers, and the shade on them. Made at once, or in parts while
// another view is shown, none of which takes a frame's time. Main thread.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/frame/still_meshes.h"
#include "engine/render/pixels/host_photograph.h"
#include "engine/render/pixels/photograph_layers.h"
#include "engine/render/pixels/shade_pixels.h"
#include "engine/render/pixels/shade_tiles.h"
#include "engine/render/pixels/shadow_mask.h"
#include "engine/render/scene.h"
#include "engine/vk/buffer.h"

namespace onggi::render {

// Numbers for pictures of tiles, see DamageTracker. None of them is given twice, so that no target takes one
// picture for another. The first is 1.
class TileNumbers {
  public:
    [[nodiscard]] std::uint64_t next() { return ++last_; }

  private:
    std::uint64_t last_ = 0;
};

// Memory that will be written to for the first time where a frame has no time for it. The system gives a page
// when it is first written to, which takes a virtual machine up to 15 microseconds: 14 ms a picture of
// 1280x720.
inline void touch(const vk::Buffer& buffer) {
    std::fill_n(buffer.mapped(), buffer.size(), std::byte{0});
}

// The pipelines that draw what stands still into the layers that the processor reads.

// Two numbers of sixteen bits each, as two bytes each: see shaders/packed.glsl.
constexpr VkFormat kPackedFormat = VK_FORMAT_R8G8B8A8_UNORM;

struct LayerPipelines {
    vk::Pipeline backdrop;  // this and the next of a room in its own colours
    vk::Pipeline still;
    vk::Pipeline places;  // of a photographed room
};

// Those that every scene may need, and those that this scene needs besides; each once.
Result<void> create_pipelines(const FrameContext& frame, LayerPipelines& pipelines);
Result<void> fit_pipelines(const FrameContext& frame, const Scene& scene, LayerPipelines& pipelines);

// The photographs of the room where the processor lays them: those that are shown and those that may be
// next.
class HostBackgrounds {
  public:
    // Reads those of the scene that are not here, and lets go of those that it has not any more. Errors: a
    // background that is not whole.
    Result<void> fit(const FrameContext& frame, const Scene& scene);
    // One of the scene's. Errors: it is none.
    [[nodiscard]] Result<const HostBackground*> find(
        const std::shared_ptr<const Background>& background) const;

  private:
    struct Resident {
        std::shared_ptr<const Background> background;  // held, so that no other can have its address
        HostBackground photographs;
    };
    std::vector<std::unique_ptr<Resident>> residents_;
};

// The kept still life with the shade on it, in the light of the hour: kept by the processor where that is
// the device, and shaded again where the shade or the light has changed.
class HostShade {
  public:
    // Makes room for a picture of this size. The device is idle.
    Result<void> fit(const FrameContext& frame);
    // Nothing will be shaded for a while: gives its memory back until the next fit(). The device is idle.
    void let_go() { shaded_ = {}; }
    // The layers are others than before: whatever lies over them has to be shaded.
    void learn(const FrameContext& frame, const ShadeLayers& layers);

    // Lays the scene's shade over its layers, which takes time only where it has changed and, by `moving`,
    // is seen (see ShadeTiles::take()); true: it has. `frame.built` must be this frame's. The device is idle.
    bool shade(const FrameContext& frame, const Scene& scene, const ShadeLayers& layers,
               std::span<const std::uint8_t> moving, TileNumbers& numbers);
    // As large as the picture: what shade() made, and which tile of it is which.
    [[nodiscard]] const vk::Buffer& shaded() const { return shaded_; }
    [[nodiscard]] const ShadeTiles& tiles() const { return tiles_; }

  private:
    void note_light(const LightLevels& levels);

    bool has_mask_ = false;  // of these layers
    vk::Buffer shaded_;
    std::unique_ptr<ShadowMask> mask_ = std::make_unique<ShadowMask>();
    std::unique_ptr<ShadowMask> mask_before_ = std::make_unique<ShadowMask>();
    std::uint64_t mask_of_ = 0;
    LightLevels levels_;
    ShadeTiles tiles_;  // of `shaded_`
    ShadeEdges edges_;
    std::vector<PixelRect> rects_;
};

// The layers of a still life, where the processor reads them to lay the shade over it (shade_pixels.h), by
// full daylight, with its depth: drawn by the device, and of a photographed room only where things are, for
// the colours are the photographs'.
class StillLayers {
  public:
    // Makes room for a picture of this size. The device is idle.
    Result<void> fit(const FrameContext& frame);
    // Nothing will be read for a while: gives the memory back until the next fit(). The device is idle.
    void let_go();

    // The device's part: draws and reads back, and waits for it. The frame's uniforms lie on the device, with
    // all lights full. The device is idle. Errors: the device's. Of a room in its own colours it is all:
    Result<void> draw_own(FrameContext& frame, const LayerPipelines& pipelines, const StillMeshes& meshes);
    // Of a photographed one it is where things are, rows by rows until all are drawn; over them come the
    // colours, likewise, see lay_photographs().
    Result<void> draw_places(FrameContext& frame, const LayerPipelines& pipelines, const StillMeshes& meshes,
                             RowSpan rows);
    void lay(const HostBackground& background, vec4 window, RowSpan rows);
    // At last: what was drawn as coordinates becomes what layers() says.
    void turn_into_places();

    [[nodiscard]] ShadeLayers layers() const;
    [[nodiscard]] const vk::Buffer& with_key() const { return with_key_; }
    [[nodiscard]] const vk::Buffer& depth() const { return depth_; }  // a float a pixel

  private:
    VkExtent2D extent_{};
    vk::Buffer with_key_;
    vk::Buffer without_key_;
    vk::Buffer places_;
    vk::Buffer depth_;
};

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

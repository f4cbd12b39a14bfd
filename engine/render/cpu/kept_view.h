// The still life as seen by one camera: its layers, and the shade on them. Made at once, or in parts while
// another view is shown; each part fits into a frame. Main thread.
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

// Version numbers for tiles, see DamageTracker. Numbers are never reused, so that a target never mistakes one
// picture for another. The first is 1.
class TileNumbers {
  public:
    [[nodiscard]] std::uint64_t next() { return ++last_; }

  private:
    std::uint64_t last_ = 0;
};

// Writes to memory ahead of a frame that has no time for page faults. The system maps a page on its first
// write, which takes a virtual machine up to 15 microseconds: 14 ms for a picture of 1280x720.
inline void touch(const vk::Buffer& buffer) {
    std::fill_n(buffer.mapped(), buffer.size(), std::byte{0});
}

// The pipelines that draw the still life into the layers that the processor reads.

// Two 16-bit numbers as two bytes each, see shaders/packed.glsl.
constexpr VkFormat kPackedFormat = VK_FORMAT_R8G8B8A8_UNORM;

struct LayerPipelines {
    vk::Pipeline backdrop;  // `backdrop` and `still`: of a room in its own colours
    vk::Pipeline still;
    vk::Pipeline places;  // of a photographed room
};

// create_pipelines() makes those that every scene may need; fit_pipelines() adds those that this scene needs,
// once.
Result<void> create_pipelines(const FrameContext& frame, LayerPipelines& pipelines);
Result<void> fit_pipelines(const FrameContext& frame, const Scene& scene, LayerPipelines& pipelines);

// The room's photographs in the processor's memory: those that are shown and those that may be next.
class HostBackgrounds {
  public:
    // Reads the scene's photographs that are missing, and releases those that the scene no longer names.
    // Errors: a background's photographs are incomplete.
    Result<void> fit(const FrameContext& frame, const Scene& scene);
    // Returns a background of the scene. Errors: the scene does not name it.
    [[nodiscard]] Result<const HostBackground*> find(
        const std::shared_ptr<const Background>& background) const;

  private:
    struct Resident {
        std::shared_ptr<const Background> background;  // keeps its address from being reused
        HostBackground photographs;
    };
    std::vector<std::unique_ptr<Resident>> residents_;
};

// The still life with shade and the current light levels applied. The processor keeps it and recomputes the
// tiles where shade or light has changed.
class HostShade {
  public:
    // Allocates memory for a picture of this size. The device is idle.
    Result<void> fit(const FrameContext& frame);
    // Releases the memory until the next fit(), when no shading is needed. The device is idle.
    void let_go() { shaded_ = {}; }
    // The layers have changed: everything must be shaded again.
    void learn(const FrameContext& frame, const ShadeLayers& layers);

    // Updates the shaded picture in the tiles where shade or light has changed (see ShadeTiles::take()).
    // Returns whether the shade changed. `frame.built` must be this frame's. The device is idle.
    bool shade(const FrameContext& frame, const Scene& scene, const ShadeLayers& layers,
               TileNumbers& numbers);
    // The shaded picture, as large as the frame, and the version of each of its tiles.
    [[nodiscard]] const vk::Buffer& shaded() const { return shaded_; }
    [[nodiscard]] const ShadeTiles& tiles() const { return tiles_; }

  private:
    void note_light(const LightLevels& levels);

    bool has_mask_ = false;  // for these layers
    vk::Buffer shaded_;
    std::unique_ptr<ShadowMask> mask_ = std::make_unique<ShadowMask>();
    std::unique_ptr<ShadowMask> mask_before_ = std::make_unique<ShadowMask>();
    std::uint64_t mask_of_ = 0;
    LightLevels levels_;
    ShadeTiles tiles_;  // of shaded_
    ShadeEdges edges_;
    std::vector<PixelRect> rects_;
};

// The still life's layers in memory that the processor reads to apply the shade (shade_pixels.h): colours in
// full daylight, shadow-mask places and depth. The device draws them; for a photographed room it draws only
// the geometry, and the colours are taken from the photographs whenever pixels are shaded.
class StillLayers {
  public:
    enum class Of { kModelledRoom, kPhotographedRoom };
    // Allocates memory for a picture of this size. The device is idle.
    Result<void> fit(const FrameContext& frame, Of room);
    // Releases the memory until the next fit(). The device is idle.
    void let_go();

    // Draws and reads back a room in its own colours; waits for the device. The frame's uniforms are on the
    // device, with all lights at full level. The device is idle. Errors: the device's.
    Result<void> draw_own(FrameContext& frame, const LayerPipelines& pipelines, const StillMeshes& meshes);
    // Draws and reads back the geometry of a photographed room, for these rows. Call it for all rows in turn.
    // `scratch` is as large as the picture; these rows of it are overwritten.
    Result<void> draw_places(FrameContext& frame, const LayerPipelines& pipelines, const StillMeshes& meshes,
                             RowSpan rows, const vk::Buffer& scratch);
    // Call last: converts the coordinates that were drawn into the places that layers() describes.
    void turn_into_places();

    // `photographs`: of the room that was drawn; null for one in its own colours. `window`: see
    // PhotographedRoom.
    [[nodiscard]] ShadeLayers layers(const HostBackground* photographs, vec4 window) const;
    [[nodiscard]] const vk::Buffer& depth() const { return depth_; }  // one float per pixel

  private:
    VkExtent2D extent_{};
    Of of_ = Of::kModelledRoom;
    vk::Buffer with_key_;  // of a modelled room, like the next
    vk::Buffer without_key_;
    vk::Buffer places_;
    vk::Buffer depth_;
    std::vector<std::uint8_t> weights_;  // of a photographed room, see ShadeLayers
};

// The inputs of a view.
struct KeptRoom {
    LayerPipelines pipelines;
    StillMeshes meshes;
    HostBackgrounds backgrounds;
};

class KeptView {
  public:
    // Whether the view is complete for this scene's camera.
    [[nodiscard]] bool shows(const FrameContext& frame, const Scene& scene) const {
        return is_whole() && is_of(frame, scene);
    }
    // Makes the next part; starts over if `seen` is another view than before. `seen` is the scene from this
    // view. `now` is the scene that the frame shows and `frame.built` was built from; it has the same light
    // and shadows. Overwrites the frame's uniforms. The device is idle. Errors: the device's.
    Result<void> make_part(FrameContext& frame, const Scene& seen, const Scene& now, const KeptRoom& room,
                           TileNumbers& numbers);
    // Makes all remaining parts.
    Result<void> make(FrameContext& frame, const Scene& scene, const KeptRoom& room, TileNumbers& numbers);
    // The view's inputs have changed.
    void forget() { parts_made_ = 0; }
    // Allocates the memory in advance, so that no part has to. The device is idle.
    Result<void> fit(const FrameContext& frame, StillLayers::Of room);
    // Releases the memory of a view that is no longer needed. The device is idle.
    void let_go();
    // Lends the memory of a view that was left as two pictures of the frame's size, until the view is made
    // again. Precondition: the memory is allocated. `first` holds the picture that was shaded last.
    struct Lent {
        const vk::Buffer& first;
        const vk::Buffer& second;
    };
    [[nodiscard]] Lent lend();

    // Applies shade and light levels. Precondition: the view is complete. Returns whether the shade changed.
    // Errors: the room lacks the view's photographs.
    Result<bool> shade(const FrameContext& frame, const Scene& scene, const KeptRoom& room,
                       TileNumbers& numbers);
    [[nodiscard]] const vk::Buffer& shaded() const { return shade_.shaded(); }
    [[nodiscard]] std::span<const std::uint64_t> numbers() const { return shade_.tiles().numbers(); }
    [[nodiscard]] std::span<const float> depth() const { return layers_.depth().as<const float>(); }

  private:
    static constexpr int kBands = 6;  // of a photographed room, drawn and filled in one after another
    enum Part { kDrawn = kBands, kLearnt, kShaded };

    [[nodiscard]] bool is_whole() const { return parts_made_ == kShaded; }
    [[nodiscard]] bool is_of(const FrameContext& frame, const Scene& scene) const;
    Result<void> draw(FrameContext& frame, const Scene& seen, const KeptRoom& room);
    Result<void> draw_band(FrameContext& frame, const KeptRoom& room);

    int parts_made_ = 0;
    std::uint64_t of_ = 0;  // hash of the scene that it shows
    std::shared_ptr<const Background> background_;
    vec4 window_{1.0F, 1.0F, 0.0F, 0.0F};  // of its photographs
    StillLayers layers_;
    HostShade shade_;
};

}  // namespace onggi::render

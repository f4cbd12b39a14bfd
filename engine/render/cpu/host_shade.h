// The kept still life with the shade on it, in the light of the hour: kept by the processor where that is
// the device, and shaded again where the shade or the light has changed. Main thread.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/render/cpu/tile_numbers.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/pixels/shade_edges.h"
#include "engine/render/pixels/shade_pixels.h"
#include "engine/render/pixels/shade_tiles.h"
#include "engine/render/pixels/shadow_mask.h"

namespace onggi::render {

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

}  // namespace onggi::render

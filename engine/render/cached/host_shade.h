// The cached still life with the shade on it, in the light of the hour: kept by the processor where that is
// the device, and shaded again where the shade or the light has changed. Main thread.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

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
    // The layers are others than before.
    void forget() { has_layers_ = false; }
    // Nothing will be shaded for a while: gives its memory back until the next fit(). The device is idle.
    void let_go();

    // Lays the scene's shade over its layers, which takes time only where it has changed; `frame.built` must
    // be this frame's. The device is idle.
    void shade(FrameContext& frame, const Scene& scene, const ShadeLayers& layers);
    // As large as the picture: what shade() made, and which tile of it is which.
    [[nodiscard]] const vk::Buffer& shaded() const { return shaded_; }
    [[nodiscard]] const ShadeTiles& tiles() const { return tiles_; }

  private:
    void note_light(const LightLevels& levels);

    bool has_layers_ = false;
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

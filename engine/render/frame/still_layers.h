// The layers of a still life, where the processor reads them to lay the shade over it (shade_pixels.h): drawn
// once by the device, by full daylight, with its depth; of a photographed room the device draws only where
// things are, and the colours are the photographs'. Main thread.
#pragma once

#include "engine/core/result.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/frame/plate_pass.h"
#include "engine/render/frame/still_meshes.h"
#include "engine/render/pixels/shade_pixels.h"

namespace onggi::render {

class StillLayers {
  public:
    // Makes room for a picture of this size; true if it is another than before. The device is idle.
    Result<bool> fit(const FrameContext& frame);
    // Nothing will be read for a while: gives the memory back until the next fit(). The device is idle.
    void let_go();

    // Draws and reads back, and waits for it. The frame's uniforms lie on the device, with all lights full.
    // `plates`: null for a room in its own colours. The device is idle. Errors: the device's.
    Result<void> draw(FrameContext& frame, const Scene& scene, const StillMeshes& meshes,
                      const PlatePass* plates);
    [[nodiscard]] ShadeLayers layers() const;
    [[nodiscard]] const vk::Buffer& depth() const { return depth_; }  // a float a pixel

  private:
    Result<void> draw_own(FrameContext& frame, const StillMeshes& meshes);
    Result<void> draw_photographed(FrameContext& frame, const Scene& scene, const StillMeshes& meshes,
                                   const PlatePass& plates);

    VkExtent2D extent_{};
    vk::Buffer with_key_;
    vk::Buffer without_key_;
    vk::Buffer places_;  // coordinates in the mask; turned into mask_place() when they have come
    vk::Buffer depth_;
};

}  // namespace onggi::render

// The layers of a still life, where the processor reads them to lay the shade over it (shade_pixels.h), by
// full daylight, with its depth: drawn by the device, and of a photographed room only where things are, for
// the colours are the photographs'. Main thread.
#pragma once

#include "engine/core/result.h"
#include "engine/render/cpu/layer_pipelines.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/frame/still_meshes.h"
#include "engine/render/pixels/host_photograph.h"
#include "engine/render/pixels/photograph_layers.h"
#include "engine/render/pixels/shade_pixels.h"

namespace onggi::render {

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

}  // namespace onggi::render

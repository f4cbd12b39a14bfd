// A picture that the processor draws into, in memory that the device reads, and its depth, which it does not.
// Main thread. Pixels.
#pragma once

#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/pixels/picture_shapes.h"
#include "engine/vk/buffer.h"

namespace onggi::render {

class Framebuffer {
  public:
    // As large as the frame; what was in it is lost where that has changed. `name` is for tools that show
    // the device's objects. The device is idle. Errors: no memory.
    Result<void> fit(const FrameContext& frame, std::string_view name);
    [[nodiscard]] PictureCanvas canvas();
    [[nodiscard]] const vk::Buffer& picture() const { return picture_; }

  private:
    vk::Buffer picture_;
    std::vector<float> depth_;
    PictureSize size_;
};

}  // namespace onggi::render

// The clay, drawn by the device from its rings, with what it needs there. Main thread.
#pragma once

#include <cstdint>

#include "engine/core/result.h"
#include "engine/render/frame/frame_context.h"

namespace onggi::render {

class LathePass {
  public:
    Result<void> create(const FrameContext& frame);
    void upload(const BuiltFrame& built) const;

    // The lathe, inside the caller's pass.
    void draw(const FrameContext& frame) const;

  private:
    Result<void> upload_slip(const FrameContext& frame);

    vk::Buffer outline_;
    vk::Buffer rows_;
    vk::Buffer vertices_;
    vk::Buffer normals_;
    vk::BufferView normal_texels_;
    vk::Buffer slip_;  // the same texels as those of the image
    vk::BufferView slip_texels_;
    vk::Buffer indices_;
};

}  // namespace onggi::render

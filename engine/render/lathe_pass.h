// The clay: a pot drawn from its rings, with what it needs on the device. Main thread.
#pragma once

#include "engine/core/result.h"
#include "engine/render/frame_context.h"

namespace onggi::render {

class LathePass {
  public:
    Result<void> create(const FrameContext& frame);
    void upload(FrameContext& frame) const;

    // The outline's normals into their texture; before any pass that draws the lathe.
    void record(const FrameContext& frame) const;
    // The lathe, inside the caller's pass.
    void draw(const FrameContext& frame) const;

  private:
    static Result<void> upload_slip(const FrameContext& frame);

    vk::Buffer outline_;
    vk::Buffer rows_;
    vk::Buffer vertices_;
    vk::Buffer normals_;
    vk::Buffer indices_;
};

}  // namespace onggi::render

// Smooths the outlines of what moves where the picture has one sample a pixel: the rectangle they lie in is
// copied aside, and thin strips along them are drawn from the copy. Main thread.
#pragma once

#include <vector>

#include "engine/core/result.h"
#include "engine/render/frame_context.h"
#include "engine/render/outline_strips.h"
#include "engine/vk/frame_target.h"

namespace onggi::render {

class EdgePass {
  public:
    Result<void> create(const FrameContext& frame);
    void resized(const FrameContext& frame) const;
    void upload(FrameContext& frame);
    // After the pass that drew what moves, whose depth must have been kept. The target stays a colour target.
    void record(const FrameContext& frame, const vk::TargetImage& target) const;

  private:
    std::vector<StripCorner> corners_;
    vk::Buffer corner_buffer_;
    vk::Buffer indices_;
};

}  // namespace onggi::render

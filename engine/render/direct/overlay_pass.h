// Has the device draw the overlay after the scene: two pipelines, one texture, one vertex buffer. Where the
// device is the processor, PaintedOverlay stands in its place. Main thread.
#pragma once

#include "engine/render/frame/frame_context.h"
#include "engine/render/overlay.h"
#include "engine/vk/buffer.h"
#include "engine/vk/frame_target.h"
#include "engine/vk/image.h"
#include "engine/vk/pipeline.h"

namespace onggi::render {

class OverlayPass {
  public:
    Result<void> create(const FrameContext& frame);
    // Makes room for what the overlay brings and fills the buffers. The device is idle. Null: no overlay.
    Result<void> fit(const FrameContext& frame, const Overlay* overlay);
    // Copies new pictures into the atlas.
    void record_uploads(const FrameContext& frame);
    // The target is laid out as colour, as the scene left it; or in any way when nothing has been drawn.
    void record(const FrameContext& frame, const vk::TargetImage& target, bool after_scene);

  private:
    Result<void> fit_atlas(const FrameContext& frame, int side_px);
    Result<void> fit_kept(const FrameContext& frame);
    Result<void> fill(const FrameContext& frame, const ui::DrawList& list);
    void draw_list(const FrameContext& frame, VkImageView view, bool keep_what_is_there) const;

    vk::BoundSet set_;
    vk::PipelineLayout layout_;
    vk::Pipeline boxes_;
    vk::Pipeline pictures_;
    vk::Sampler sampler_;
    vk::Image atlas_;
    bool atlas_is_new_ = true;
    vk::Buffer staging_;
    vk::Buffer vertices_;
    vk::Buffer indices_;
    vk::Image kept_;  // the last covering overlay, drawn
    std::uint64_t kept_hash_ = 0;
    const Overlay* overlay_ = nullptr;  // of this frame
    std::uint64_t hash_ = 0;
};

}  // namespace onggi::render

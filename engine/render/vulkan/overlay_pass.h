// Draws the overlay on the device after the scene: two pipelines, one texture, one vertex buffer. Main
// thread.
#pragma once

#include "engine/render/overlay.h"
#include "engine/render/vulkan/vulkan_frame.h"
#include "engine/vk/buffer.h"
#include "engine/vk/frame_target.h"
#include "engine/vk/image.h"
#include "engine/vk/pipeline.h"

namespace onggi::render {

class OverlayPass {
  public:
    Result<void> create(const VulkanFrame& frame);
    // Allocates memory for the overlay and fills the buffers. Null: no overlay. The device is idle.
    Result<void> fit(const VulkanFrame& frame, const Overlay* overlay);
    // Records copies of new pictures into the atlas.
    void record_uploads(const VulkanFrame& frame);
    // `after_scene`: the scene was drawn and the target is in the colour layout; else its contents are
    // undefined.
    void record(const VulkanFrame& frame, const vk::TargetImage& target, bool after_scene);

  private:
    Result<void> fit_atlas(const VulkanFrame& frame, int side_px);
    Result<void> fit_kept(const VulkanFrame& frame);
    Result<void> fill(const VulkanFrame& frame, const ui::DrawList& list);
    void draw_list(const VulkanFrame& frame, VkImageView view, bool keep_what_is_there) const;

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
    vk::Image kept_;  // the last covering overlay, as drawn
    std::uint64_t kept_hash_ = 0;
    const Overlay* overlay_ = nullptr;  // of this frame
    std::uint64_t hash_ = 0;
};

}  // namespace onggi::render

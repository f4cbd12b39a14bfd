// The picture as GPUs draw it, and as screenshots are drawn everywhere: everything by the device in every
// frame. Main thread.
#pragma once

#include "engine/render/frame/render_backend.h"
#include "engine/render/vulkan/lathe_pass.h"
#include "engine/render/vulkan/overlay_pass.h"
#include "engine/render/vulkan/prop_pass.h"
#include "engine/render/vulkan/room_pass.h"
#include "engine/render/vulkan/shadow_pass.h"
#include "engine/render/vulkan/view_fade.h"

namespace onggi::render {

class VulkanBackend : public RenderBackend {
  public:
    VulkanBackend(vk::Device& device, const RendererDesc& desc) : frame_{{.device = device, .desc = desc}} {}

    Result<void> create() override;
    Result<void> fit(const Scene& scene, VkExtent2D target) override;
    Result<bool> draw(const Scene& scene, const vk::TargetImage& target, const Overlay* overlay) override;
    [[nodiscard]] FrameContext& frame() override { return frame_; }

  private:
    Result<void> fit_size(VkExtent2D target);
    Result<void> upload(const Scene& scene);
    void record(const Scene& scene, const vk::TargetImage& target);
    // Where the scene's picture is drawn if not into the target, over which it is then stretched: it is
    // smaller, or may be wanted again. Else null.
    [[nodiscard]] const vk::Image* picture_apart() const;
    // A picture that was just drawn, over the target.
    void stretch(const vk::Image& picture, const vk::TargetImage& target) const;

    VulkanFrame frame_;
    RoomPass room_;
    ShadowPass shadow_;
    LathePass lathe_;
    PropPass props_;
    OverlayPass overlay_;
    ViewFade fade_;
};

}  // namespace onggi::render

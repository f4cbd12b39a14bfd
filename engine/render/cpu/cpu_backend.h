// The picture where the device is the processor: what stands still is drawn once by the device and kept where
// the processor shades it; what moves the processor draws over that, and the overlay too. The device is left
// with copies, and of those only what a target does not show already. Another view is made in parts while the
// one before is shown, and then fades in. Main thread.
#pragma once

#include "engine/render/cpu/cross_fade.h"
#include "engine/render/cpu/host_frame.h"
#include "engine/render/cpu/host_moving.h"
#include "engine/render/cpu/kept_view.h"
#include "engine/render/cpu/painted_overlay.h"
#include "engine/render/cpu/resting_scene.h"
#include "engine/render/frame/render_backend.h"
#include "engine/render/shapes/prop_models.h"

namespace onggi::render {

class CpuBackend : public RenderBackend {
  public:
    CpuBackend(vk::Device& device, const RendererDesc& desc) : frame_{.device = device, .desc = desc} {}

    Result<void> create() override;
    Result<void> fit(const Scene& scene, VkExtent2D target) override;
    Result<bool> draw(const Scene& scene, const vk::TargetImage& target, const Overlay* overlay) override;
    [[nodiscard]] FrameContext& frame() override { return frame_; }

  private:
    // What an overlay lies on; or covers, made because it will be seen when the overlay has begun to fade, or
    // because much of it is another than before: what takes several frames' time is done before anybody waits
    // for it.
    enum class Under { kScene, kCoveredScene, kRestingScene, kNothing };

    void fit_size(VkExtent2D target);
    Under look_under(const Scene& scene, const Overlay* overlay);
    Result<HostPicture> make(const Scene& scene);
    void change_view(const Scene& scene);
    Result<void> make_next_view(const Scene& scene);
    [[nodiscard]] HostPicture picture_of(const KeptView& view) const;
    [[nodiscard]] HostPicture picture() const;

    FrameContext frame_;
    PropModels models_;
    KeptRoom room_;
    TileNumbers numbers_;
    KeptView shown_;
    KeptView next_;
    bool has_picture_ = false;  // of a frame as large as this one: picture(), until the next is built
    CrossFade fade_;
    HostMoving moving_;
    PaintedOverlay overlay_;
    RestingScene resting_;
    HostFrame bringing_;
    bool will_rest_ = false;  // this frame's overlay says that the scene may
};

}  // namespace onggi::render

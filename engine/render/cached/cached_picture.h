// The picture where the device is the processor: what stands still is drawn once by the device and kept where
// the processor shades it, or bent by it while the camera moves; what moves the processor draws over that,
// and the overlay too. The device is left with copies, and of those only what a target does not show already.
// Main thread.
#pragma once

#include <cstdint>

#include "engine/render/cached/host_frame.h"
#include "engine/render/cached/host_glide.h"
#include "engine/render/cached/host_moving.h"
#include "engine/render/cached/host_shade.h"
#include "engine/render/cached/painted_overlay.h"
#include "engine/render/cached/resting_scene.h"
#include "engine/render/frame/picture_way.h"
#include "engine/render/shapes/mover_models.h"

namespace onggi::render {

class CachedPicture : public PictureWay {
  public:
    Result<void> create(FrameContext& frame) override;
    void resized() override { resting_.forget(); }
    Result<bool> draw(FrameContext& frame, StillPass& room, const Scene& scene, const vk::TargetImage& target,
                      const Overlay* overlay) override;

  private:
    // What an overlay lies on; or covers, made because it will be seen when the overlay has begun to fade, or
    // because much of it is another than before: what takes several frames' time is done before anybody waits
    // for it.
    enum class Under { kScene, kCoveredScene, kRestingScene, kNothing };

    Under look_under(const FrameContext& frame, const StillPass& room, const Scene& scene,
                     const Overlay* overlay);
    Result<HostPicture> make(FrameContext& frame, StillPass& room, const Scene& scene);
    Result<HostPicture> make_standing(FrameContext& frame, StillPass& room, const Scene& scene);
    Result<HostPicture> make_bent(FrameContext& frame, StillPass& room, const Scene& scene);

    MoverModels models_;
    HostShade shade_;
    HostGlide glide_;
    HostMoving moving_;
    PaintedOverlay overlay_;
    RestingScene resting_;
    HostFrame bringing_;
    bool will_rest_ = false;  // this frame's overlay says that the scene may
};

}  // namespace onggi::render

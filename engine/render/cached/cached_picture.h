// The picture where the device is the processor: what stands still is drawn once by the device and kept where
// the processor shades it; what moves the processor draws over that, and the overlay too. The device is left
// with copies, and of those only what a target does not show already. Another view is made in parts while the
// one before is shown, and then fades in. Main thread.
#pragma once

#include "engine/render/cached/cross_fade.h"
#include "engine/render/cached/host_frame.h"
#include "engine/render/cached/host_moving.h"
#include "engine/render/cached/kept_view.h"
#include "engine/render/cached/painted_overlay.h"
#include "engine/render/cached/resting_scene.h"
#include "engine/render/frame/picture_way.h"
#include "engine/render/shapes/mover_models.h"

namespace onggi::render {

class CachedPicture : public PictureWay {
  public:
    Result<void> create(FrameContext& frame) override;
    void resized() override;
    Result<void> fit(FrameContext& frame, const Scene& scene) override;
    Result<bool> draw(FrameContext& frame, const Scene& scene, const vk::TargetImage& target,
                      const Overlay* overlay) override;

  private:
    // What an overlay lies on; or covers, made because it will be seen when the overlay has begun to fade, or
    // because much of it is another than before: what takes several frames' time is done before anybody waits
    // for it.
    enum class Under { kScene, kCoveredScene, kRestingScene, kNothing };

    Under look_under(const FrameContext& frame, const Scene& scene, const Overlay* overlay);
    Result<HostPicture> make(FrameContext& frame, const Scene& scene);
    void change_view(const FrameContext& frame, const Scene& scene);
    Result<void> make_next_view(FrameContext& frame, const Scene& scene);
    [[nodiscard]] HostPicture picture_of(const FrameContext& frame, const KeptView& view) const;
    [[nodiscard]] HostPicture picture(const FrameContext& frame) const;

    MoverModels models_;
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

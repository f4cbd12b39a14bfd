// The picture as GPUs draw it, and as screenshots are drawn everywhere: everything by the device in every
// frame, several samples a pixel. Main thread.
#pragma once

#include "engine/render/direct/lathe_pass.h"
#include "engine/render/direct/mover_pass.h"
#include "engine/render/direct/overlay_pass.h"
#include "engine/render/direct/room_pass.h"
#include "engine/render/direct/shadow_pass.h"
#include "engine/render/frame/picture_way.h"
#include "engine/render/shapes/mover_models.h"

namespace onggi::render {

class DirectPicture : public PictureWay {
  public:
    Result<void> create(FrameContext& frame) override;
    Result<void> fit(FrameContext& frame, const Scene& scene) override;
    Result<bool> draw(FrameContext& frame, const Scene& scene, const vk::TargetImage& target,
                      const Overlay* overlay) override;

  private:
    Result<void> upload(FrameContext& frame, const Scene& scene);
    void record(FrameContext& frame, const Scene& scene, const vk::TargetImage& target);

    RoomPass room_;
    ShadowPass shadow_;
    LathePass lathe_;
    MoverModels models_;
    MoverPass movers_;
    OverlayPass overlay_;
};

}  // namespace onggi::render

// One of the two ways to a picture: see direct_picture.h and cached_picture.h. Main thread.
#pragma once

#include "engine/core/result.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/frame/still_pass.h"
#include "engine/render/overlay.h"
#include "engine/vk/frame_target.h"

namespace onggi::render {

class PictureWay {
  public:
    PictureWay() = default;
    virtual ~PictureWay() = default;
    PictureWay(const PictureWay&) = delete;
    PictureWay& operator=(const PictureWay&) = delete;

    // Once, with the pipelines and images of fixed size there. Errors: the device's.
    virtual Result<void> create(FrameContext& frame) = 0;
    // The picture has another size. The device is idle.
    virtual void resized() {}
    // Puts all that a frame shows together and records its commands. The device is idle; `room` has what it
    // needs of the scene. False: the scene is not in it, because a screen covers it or it stands still.
    virtual Result<bool> draw(FrameContext& frame, StillPass& room, const Scene& scene,
                              const vk::TargetImage& target, const Overlay* overlay) = 0;
};

}  // namespace onggi::render

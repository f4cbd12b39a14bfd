// One of the two ways to a picture: see direct_picture.h and cached_picture.h. Main thread.
#pragma once

#include "engine/core/result.h"
#include "engine/render/frame/frame_context.h"
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
    // What stands still in the scene to where it is drawn from, if it is another. The device is idle.
    virtual Result<void> fit(FrameContext& frame, const Scene& scene) = 0;
    // Puts all that a frame shows together and records its commands; after fit() with the same scene. The
    // device is idle. False: the scene is not in it, because a screen covers it or it stands still.
    virtual Result<bool> draw(FrameContext& frame, const Scene& scene, const vk::TargetImage& target,
                              const Overlay* overlay) = 0;
};

}  // namespace onggi::render

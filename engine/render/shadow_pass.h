// The shadow that moving things cast on what stands still: a small mask, drawn when they change, and the
// shade laid over the cached layers by it; or both of them by the processor. Main thread.
#pragma once

#include <cstdint>

#include "engine/core/result.h"
#include "engine/render/frame_context.h"
#include "engine/render/host_shade.h"

namespace onggi::render {

class ShadowPass {
  public:
    // For a picture of this size. The device is idle.
    Result<void> fit(const FrameContext& frame);
    // Decides who shades and whether the mask has to be made again, and notes it in the stats. After
    // StillPass::update(); the device is idle.
    void update(FrameContext& frame, const Scene& scene);
    // The mask, if update() asked for it.
    void record(const FrameContext& frame);
    // Cached: the shade over the still life, which has been copied into the target. The first before the
    // caller's pass, the second in it, before whatever moves; one of them does something.
    void record_shaded(const FrameContext& frame, VkImage target);
    void draw_shade(const FrameContext& frame) const;

  private:
    std::uint64_t drawn_ = 0;  // hash of what the mask shows
    bool has_mask_ = false;
    HostShade host_;
    bool host_shades_ = false;  // this frame
};

}  // namespace onggi::render

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
    void update(FrameContext& frame, const Scene& scene, const StillBounds& still);
    // In place of update(), where this frame's shade is none of it.
    void pause();
    // The mask, if update() asked for it.
    void record(const FrameContext& frame);
    // Cached: what the processor shaded; null if it does not shade this frame. Then the caller copies the
    // still life, and draw_shade() inside a pass, before whatever moves, lays the shade over it.
    [[nodiscard]] const HostShade* host_shade() const { return host_shades_ ? &host_ : nullptr; }
    [[nodiscard]] const HostShade& host() const { return host_; }
    // False as long as the processor has not got this still life's layers but is about to.
    [[nodiscard]] bool is_ready() const { return host_shades_ || !host_.is_wide_enough(); }
    void draw_shade(const FrameContext& frame) const;
    // After the copy: the layers to where the processor finds them in the next frame, if it is to shade.
    void record_reading(const FrameContext& frame);

  private:
    std::uint64_t drawn_ = 0;  // hash of what the mask shows
    bool has_mask_ = false;
    std::vector<vec4> rects_;  // that a shader shades
    HostShade host_;
    bool host_shades_ = false;  // this frame
};

}  // namespace onggi::render

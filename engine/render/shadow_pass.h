// The shadow that moving things cast on what stands still: a small mask, drawn when they change, and the
// shade laid over the cached layers by it. Main thread.
#pragma once

#include <cstdint>

#include "engine/render/frame_context.h"

namespace onggi::render {

class ShadowPass {
  public:
    // Decides whether the mask has to be drawn again, and notes it in the stats.
    void update(FrameContext& frame, const Scene& scene);
    // The mask, if update() asked for it.
    void record(const FrameContext& frame);
    // Cached: the shade over the still life, inside the caller's pass, before whatever moves.
    static void draw_shade(const FrameContext& frame);

  private:
    std::uint64_t drawn_ = 0;  // hash of what the mask shows
    bool has_mask_ = false;
};

}  // namespace onggi::render

// The shadow that moving things cast on what stands still: a small mask, drawn when they change. Main thread.
#pragma once

#include <cstdint>

#include "engine/render/vulkan/vulkan_frame.h"

namespace onggi::render {

class ShadowPass {
  public:
    // Decides whether the mask has to be drawn again, and notes it in the stats.
    void update(VulkanFrame& frame, const Scene& scene);
    // The mask, if update() asked for it.
    void record(const VulkanFrame& frame);

  private:
    std::uint64_t drawn_ = 0;  // hash of what the mask shows
    bool has_mask_ = false;
};

}  // namespace onggi::render

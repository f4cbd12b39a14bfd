// Statistics of a rendered frame. Pixels, ms.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/render/pass_clock.h"

namespace onggi::render {

// The work that a frame submitted to the device.
struct FrameWork {
    int draws = 0;
    std::size_t vertices = 0;        // vertices, or indices of indexed draws, summed over all draws
    std::size_t uploaded_bytes = 0;  // written to device memory: uniforms, texels, pictures
};

// Statistics of the last frame, for tests and monitoring.
struct FrameStats {
    int rings = 0;
    float ring_error_px = 0.0F;  // the tolerance at which the rings fit under the cap
    bool still_life_drawn = false;
    bool shadow_drawn = false;
    bool next_view_ready = false;  // the scene's next view can be shown by the next frame without extra time
    FrameWork work{};
    double host_ms = 0.0;    // from acquiring the target's image to submitting the frame; 0: no host clock
    double device_ms = 0.0;  // of the previous frame, from its first command to its last; 0: not measured
    // The measured parts of the same frame on the host and on the device.
    std::vector<PassTime> parts{};
    bool device_drew_scene = false;  // in the same frame; false: a screen or a resting scene
};

}  // namespace onggi::render

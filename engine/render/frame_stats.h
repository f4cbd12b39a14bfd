// How a frame went. Pixels, ms.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/render/pass_clock.h"

namespace onggi::render {

// What a frame asked of the device.
struct FrameWork {
    int draws = 0;
    std::size_t vertices = 0;        // or indices, of all draws
    std::size_t uploaded_bytes = 0;  // to where the device reads: numbers, texels, pictures
};

// What the last frame took, for tests and for whoever watches.
struct FrameStats {
    int rings = 0;
    float ring_error_px = 0.0F;  // the tolerance that met the cap
    bool still_life_drawn = false;
    bool shadow_drawn = false;
    bool next_view_ready = false;  // of the scene: the next frame may show it, in no more time than another
    FrameWork work{};
    double host_ms = 0.0;    // from having the target's image to handing the frame over; 0: no clock
    double device_ms = 0.0;  // of the frame before, from its first command to its last; 0: not measured
    std::vector<PassTime> parts{};   // and of its parts, the host's too, where they are measured
    bool device_drew_scene = false;  // in that time; false: it showed a screen, or a scene at rest under one
};

}  // namespace onggi::render

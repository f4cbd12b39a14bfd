// Placement of the room's photograph in the picture: screens leave it more or less room. Any thread; pure.
#pragma once

#include "engine/math/math.h"
#include "engine/render/camera.h"

namespace onggi::wheel {

struct Framing {
    dvec2 shift{0.0};   // of the picture, in half pictures, x right and y down
    double zoom = 1.0;  // of the background about its middle, applied before the shift

    friend bool operator==(const Framing&, const Framing&) = default;
};

// A background's camera with the framing applied.
[[nodiscard]] inline render::Camera framed(const render::Camera& camera, const Framing& framing) {
    render::Camera shown = render::zoomed(camera, framing.zoom);
    shown.lens_shift = vec2(framing.shift);
    return shown;
}

}  // namespace onggi::wheel

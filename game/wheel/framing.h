// Where in the picture the room's photograph is put: the design of a screen leaves it more or less room. Any
// thread; pure.
#pragma once

#include "engine/math/math.h"
#include "engine/render/camera.h"

namespace onggi::wheel {

struct Framing {
    dvec2 shift{0.0};   // of the picture, in halves of it, x right and y down
    double zoom = 1.0;  // of the background about its middle, before it is shifted

    friend bool operator==(const Framing&, const Framing&) = default;
};

// A background's camera as the framing asks for it.
[[nodiscard]] inline render::Camera framed(const render::Camera& camera, const Framing& framing) {
    render::Camera shown = render::zoomed(camera, framing.zoom);
    shown.lens_shift = vec2(framing.shift);
    return shown;
}

}  // namespace onggi::wheel

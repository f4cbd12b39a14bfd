// A picture of a pot drawn on the processor, with the features that the gate must handle: antialiased edges
// of four samples per pixel, shading, a highlight, sRGB. Any thread.
#pragma once

#include "engine/asset/image.h"

namespace onggi::support {

struct PotPicture {
    int width = 640;
    int height = 480;
    double wider_mm = 0.0;  // added to every radius
    double light = 1.0;     // factor of the lamp
    double shift_px = 0.0;  // of the pot to the right
};

asset::Image draw_pot(const PotPicture& picture);

}  // namespace onggi::support

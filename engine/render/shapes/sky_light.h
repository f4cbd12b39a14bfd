// The environment's diffuse light, as nine spherical-harmonic coefficients. Any thread; a pure function, run
// when the environment changes.
// R. Ramamoorthi, P. Hanrahan, "An Efficient Representation for Irradiance Environment Maps", 2001.
#pragma once

#include <array>

#include "engine/render/scene.h"

namespace onggi::render {

// Radiance from a direction (unit length), the same formula as in shaders/sky.glsl.
[[nodiscard]] vec3 sky_radiance(const Environment& environment, vec3 direction);

// Irradiance / pi for a white surface, folded so that the shader evaluates
// c0 + c1 y + c2 z + c3 x + c4 xy + c5 yz + c6 (3 z^2 - 1) + c7 xz + c8 (x^2 - y^2) at the normal.
[[nodiscard]] std::array<vec3, 9> sky_irradiance(const Environment& environment);

}  // namespace onggi::render

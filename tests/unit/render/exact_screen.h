// The exact display value of light after the tone curve, by IEC 61966-2-1, in double: the reference for the
// faster code of shaders and CPU.
#pragma once

#include <algorithm>
#include <cmath>

namespace onggi::render {

inline double exact_transferred(double c) {
    return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
}
inline double exact_untransferred(double v) {
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

// 0 to 1, of light that is not below 0.
inline double exact_shown(double light) {
    return exact_transferred(std::min(light / (0.8 * light + 0.35), 1.0));
}
}  // namespace onggi::render

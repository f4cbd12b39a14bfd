// The tone curve: maps light to the values that the screen's transfer function is applied to. Steep in the
// dark, no clipping, white at a light of 1.75.
#ifndef ONGGI_SHADERS_CURVE_H
#define ONGGI_SHADERS_CURVE_H
#include "formula.h"

#ifdef __cplusplus
namespace onggi::shaders {
#endif

CONSTANT float kCurveSlope = 0.8F;
CONSTANT float kCurveFoot = 0.35F;

// The curve's denominator; its numerator is `light`.
FORMULA COLOUR curve_under(COLOUR light) {
    return light * kCurveSlope + kCurveFoot;
}
// The inverse of the curve.
FORMULA COLOUR curve_light(COLOUR c) {
    return kCurveFoot * c / (1.0F - kCurveSlope * c);
}

#ifdef __cplusplus
}  // namespace onggi::shaders
#endif

#endif

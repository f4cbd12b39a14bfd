// Light from the sky: specular and diffuse.
#ifndef ONGGI_SHADERS_SKY_H
#define ONGGI_SHADERS_SKY_H
#include "formula.h"

#ifdef __cplusplus
namespace onggi::shaders {
#endif

// Blend factor from the horizon to the zenith or the nadir.
FORMULA REAL sky_height(REAL y) {
    REAL height = min(abs(y), 1.0F);
    return height * height * (3.0F - 2.0F * height);
}

// A soft light of the sky is a spherical Gaussian of sharpness s. Blurred by a surface, itself a lobe of
// sharpness b, its sharpness is s b / (s + b).
FORMULA REAL panel_seen_through(REAL sharpness, REAL roughness) {
    REAL alpha = roughness * roughness;
    REAL blur = 2.0F / max(alpha * alpha, 1e-4F);
    return sharpness * blur / (sharpness + blur);
}
FORMULA REAL panel_fraction(REAL sharpness, REAL soft, REAL cosine) {
    return (soft / sharpness) * exp_below_0(soft * (cosine - 1.0F));
}

// Light that a white surface facing (x, y, z) reflects diffusely, from nine coefficients.
FORMULA COLOUR sky_sum(COLOUR c0, COLOUR c1, COLOUR c2, COLOUR c3, COLOUR c4, COLOUR c5, COLOUR c6, COLOUR c7,
                       COLOUR c8, REAL x, REAL y, REAL z) {
    return max(c0 + c1 * y + c2 * z + c3 * x + c4 * (x * y) + c5 * (y * z) + c6 * (3.0F * z * z - 1.0F) +
                   c7 * (x * z) + c8 * (x * x - y * y),
               0.0F);
}

// Ambient light in a hollow takes on the hollow's own colour by interreflection.
FORMULA COLOUR open_sky_colour(REAL open, COLOUR albedo) {
    return open * (1.0F + albedo * (1.0F - open) * 1.6F);
}

#ifdef __cplusplus
}  // namespace onggi::shaders
#endif

#endif

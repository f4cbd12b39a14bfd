// Reflection of the key light by surfaces, and occlusion by the spheres that stand for hands.
#ifndef ONGGI_SHADERS_SURFACE_H
#define ONGGI_SHADERS_SURFACE_H
#include "formula.h"

#ifdef __cplusplus
namespace onggi::shaders {
#endif

CONSTANT float kPi = 3.14159265F;

// GGX with the visibility term of B. Karis, "Real Shading in Unreal Engine 4", 2013 (Schlick's form), times
// n.l. Folded into one division, which the caller does: numerator and denominator.
FORMULA REAL ggx_over(REAL n_l, REAL roughness) {
    REAL alpha = roughness * roughness;
    return alpha * alpha * n_l;
}
FORMULA REAL ggx_under(REAL n_h, REAL n_v, REAL n_l, REAL roughness) {
    REAL alpha = roughness * roughness;
    REAL a2 = alpha * alpha;
    REAL k = alpha * 0.5F;
    REAL d = n_h * n_h * (a2 - 1.0F) + 1.0F;
    REAL v = (n_v * (1.0F - k) + k) * (n_l * (1.0F - k) + k);
    return kPi * 4.0F * d * d * v;
}
FORMULA REAL ggx(REAL n_h, REAL n_v, REAL n_l, REAL roughness) {
    return ggx_over(n_l, roughness) / ggx_under(n_h, n_v, n_l, roughness);
}

// One over the length of view plus light. The half vector is their sum times this, so its cosines need no
// vector of their own.
FORMULA REAL half_of(REAL l_v) {
    return inversesqrt(max(2.0F + 2.0F * l_v, 1e-4F));
}

// Schlick's Fresnel factor.
FORMULA REAL grazing(REAL cosine) {
    REAL m = 1.0F - cosine;
    REAL m2 = m * m;
    return m2 * m2 * m;
}

// A light with a width, and subsurface scattering, soften the edge of the lit side: below `width` the cosine
// eases to 0 instead of stopping.
FORMULA REAL soft_cosine(REAL n_l, REAL width, REAL one_over_width) {
    REAL easing = max(n_l * one_over_width + 1.0F, 0.0F);
    return select(n_l > width, n_l, width * 0.25F * easing * easing);
}

// Fraction of the key light that passes a moving sphere on its way to p, 0 to 1. `tangent`: of half the
// light's width.
FORMULA REAL past_sphere(VEC4 sphere, VEC3 towards_light, REAL tangent, VEC3 p) {
    REAL x = sphere.x - p.x;
    REAL y = sphere.y - p.y;
    REAL z = sphere.z - p.z;
    REAL along = x * towards_light.x + y * towards_light.y + z * towards_light.z;
    REAL gap = sqrt(max(x * x + y * y + z * z - along * along, 0.0F)) - sphere.w;
    REAL width = max(along * tangent, 0.5F);
    return select(along > 0.0F, smoothstep(-width, width, gap), 1.0F);
}

// Fraction of the sky that the sphere leaves visible: radius r at distance d hides (r/d)^2 of what faces it.
FORMULA REAL sky_past_sphere(VEC4 sphere, VEC3 p, VEC3 n) {
    REAL x = sphere.x - p.x;
    REAL y = sphere.y - p.y;
    REAL z = sphere.z - p.z;
    REAL square = sphere.w * sphere.w;
    REAL nearness = inversesqrt(max(x * x + y * y + z * z, square));
    REAL facing = clamp((n.x * x + n.y * y + n.z * z) * nearness, 0.0F, 1.0F);
    return 1.0F - facing * square * nearness * nearness;
}

#ifdef __cplusplus
}  // namespace onggi::shaders
#endif

#endif

// Light from hands and tools: soft light on skin, cloth and wood, a wet gleam where something is smeared on
// them.
#ifndef ONGGI_SHADERS_HAND_H
#define ONGGI_SHADERS_HAND_H
#include "formula.h"
#include "sky.h"
#include "surface.h"

#ifdef __cplusplus
namespace onggi::shaders {
#endif

CONSTANT float kPlainMirror = 0.04F;

// `tone`: brightness; `smear`: coverage of `smeared`.
FORMULA COLOUR hand_albedo(COLOUR own, COLOUR smeared, REAL tone, REAL smear) {
    return mix(own * (0.5F + tone), smeared, smear);
}
FORMULA REAL hand_roughness(REAL own, REAL wetness, REAL smear) {
    return mix(own, 0.72F - 0.22F * wetness, smear);
}
// Reflectance at normal incidence.
FORMULA COLOUR hand_mirror(COLOUR albedo, REAL metalness) {
    return kPlainMirror + (albedo - kPlainMirror) * metalness;
}
// Sky light, diffuse and specular together; n_v must not be negative.
FORMULA COLOUR hand_ambient(COLOUR albedo, REAL metalness, REAL roughness, REAL n_v, REAL open,
                            COLOUR diffuse, COLOUR reflected) {
    COLOUR straight_on = hand_mirror(albedo, metalness);
    COLOUR mirror = straight_on + (max(straight_on, 1.0F - roughness) - straight_on) * grazing(n_v);
    COLOUR body = albedo * (1.0F - metalness);
    return body * diffuse * open_sky_colour(open, albedo) + mirror * reflected * open;
}
// Fraction of the key light that gets into a hollow.
FORMULA REAL hand_key_seen(REAL open) {
    return mix(0.55F, 1.0F, open);
}
// Diffuse key light: light scatters under skin and in cloth, so the edge of the lit side is soft.
FORMULA REAL hand_lit(REAL n_l) {
    return soft_cosine(n_l, 0.30F, 1.0F / 0.30F);
}
// Specular key light.
FORMULA REAL hand_gleam(REAL n_l, REAL n_v, REAL l_v, REAL roughness) {
    REAL seen_v = max(n_v, 0.05F);
    REAL n_h = max((seen_v + n_l) * half_of(l_v), 0.0F);
    return ggx(n_h, seen_v, max(n_l, 0.0F), roughness) * kPi;
}

#ifdef __cplusplus
}  // namespace onggi::shaders
#endif

#endif

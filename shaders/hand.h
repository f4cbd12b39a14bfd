// What a hand or a tool sends to the eye: soft light on flesh, cloth and wood, a wet gleam where something
// lies on it.
#ifndef ONGGI_SHADERS_HAND_H
#define ONGGI_SHADERS_HAND_H
#include "formula.h"
#include "sky.h"
#include "surface.h"

#ifdef __cplusplus
namespace onggi::shaders {
#endif

CONSTANT float kPlainMirror = 0.04F;

// `tone`: lighter or darker there; `smear`: how much of `smeared` lies on it.
FORMULA COLOUR hand_albedo(COLOUR own, COLOUR smeared, REAL tone, REAL smear) {
    return mix(own * (0.5F + tone), smeared, smear);
}
FORMULA REAL hand_roughness(REAL own, REAL wetness, REAL smear) {
    return mix(own, 0.72F - 0.22F * wetness, smear);
}
// What is mirrored, straight on.
FORMULA COLOUR hand_mirror(COLOUR albedo, REAL metalness) {
    return kPlainMirror + (albedo - kPlainMirror) * metalness;
}
// Of the sky, diffuse and mirrored together; n_v not below 0.
FORMULA COLOUR hand_ambient(COLOUR albedo, REAL metalness, REAL roughness, REAL n_v, REAL open,
                            COLOUR diffuse, COLOUR reflected) {
    COLOUR straight_on = hand_mirror(albedo, metalness);
    COLOUR mirror = straight_on + (max(straight_on, 1.0F - roughness) - straight_on) * grazing(n_v);
    COLOUR body = albedo * (1.0F - metalness);
    return body * diffuse * open_sky_colour(open, albedo) + mirror * reflected * open;
}
// Key light that gets into a hollow.
FORMULA REAL hand_key_seen(REAL open) {
    return mix(0.55F, 1.0F, open);
}
// Of the key as the body throws it back: light scatters under skin and in cloth, and the edge of the lit side
// is soft.
FORMULA REAL hand_lit(REAL n_l) {
    return soft_cosine(n_l, 0.30F, 1.0F / 0.30F);
}
// And as a mirror does.
FORMULA REAL hand_gleam(REAL n_l, REAL n_v, REAL l_v, REAL roughness) {
    REAL seen_v = max(n_v, 0.05F);
    REAL n_h = max((seen_v + n_l) * half_of(l_v), 0.0F);
    return ggx(n_h, seen_v, max(n_l, 0.0F), roughness) * kPi;
}

#ifdef __cplusplus
}  // namespace onggi::shaders
#endif

#endif

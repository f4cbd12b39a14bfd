// The turned body: rough, with streaks of fingers, under a reflective film of water or glaze. Optimised for
// one core, where a division or a root costs ten multiplications: fractions share a division.
#ifndef ONGGI_SHADERS_LATHE_H
#define ONGGI_SHADERS_LATHE_H
#include "formula.h"
#include "surface.h"

#ifdef __cplusplus
namespace onggi::shaders {
#endif

// `mark`: texels of the streaks, 0 to 1: brightness; slope around the pot and up it; thickness of the film.
FORMULA REAL lathe_tone(REAL streaks, REAL mark) {
    return 1.0F + streaks * (mark - 0.5F) * 1.7F;
}
FORMULA REAL lathe_lean(REAL streaks, REAL mark) {
    return (mark - 0.5F) * streaks;
}
// The film varies in thickness; a glaze covers everything.
FORMULA REAL lathe_film(REAL water, REAL mark, REAL glaze) {
    return max(clamp(water * (0.62F + 1.5F * (mark - 0.5F)), 0.0F, 1.0F), glaze);
}

// `water` in the body smooths it: Oren-Nayar roughness, the factor by which that dims the light, and
// roughness of the gloss.
FORMULA REAL lathe_rough(REAL water) {
    return 0.85F - 0.5F * water;
}
FORMULA REAL lathe_left(REAL rough) {
    return 1.0F / (1.0F + 0.288F * rough);
}
FORMULA REAL lathe_roughness(REAL dry, REAL wet, REAL water) {
    return mix(dry, wet, water);
}

// Retroreflection of a rough body: Y. Fujii's form of the Oren-Nayar model, 2012.
FORMULA REAL fujii_s(REAL l_v, REAL n_l, REAL n_v) {
    return l_v - n_l * n_v;
}
FORMULA REAL fujii_t(REAL s, REAL n_l, REAL n_v) {
    return select(s > 0.0F, max(max(n_l, n_v), 0.1F), 1.0F);
}
// body_sheen: the product of both lobes' denominators; `fraction`: one over body_sheen and t.
FORMULA REAL lathe_lit(REAL cosine, REAL rough, REAL s, REAL body_sheen, REAL fraction, REAL left) {
    return max(cosine * (1.0F + 0.9F * rough * s * body_sheen * fraction) * left, 0.0F);
}
// Specular lobes of body and film, as numerators and denominators; fraction_t: one over both denominators;
// straight_on: reflectance of the film at normal incidence.
FORMULA REAL lathe_gloss(REAL body_over, REAL body_under, REAL sheen_over, REAL sheen_under, REAL straight_on,
                         REAL film, REAL fraction_t) {
    return (body_over * sheen_under * (0.04F * kPi) * (1.0F - film) +
            sheen_over * body_under * (straight_on * kPi) * film) *
           fraction_t;
}
// Reflectance for sky light.
FORMULA REAL lathe_mirror(REAL straight_on, REAL n_v, REAL film) {
    return (straight_on + (1.0F - straight_on) * 0.7F * grazing(n_v)) * (0.12F + 0.88F * film);
}

// A wall close to the ground sees less of the sky; n_y: upward component of its normal.
FORMULA REAL lathe_open(REAL open, REAL height_mm, REAL n_y, REAL inside) {
    return open * (1.0F - 0.55F * exp_below_0(-height_mm * 0.07F) * (1.0F - n_y) * (1.0F - inside));
}
// How far light comes down through the mouth, whatever the wall's direction: more the deeper inside.
FORMULA REAL lathe_from_mouth(REAL inside, REAL open) {
    return inside * 0.75F * (1.0F - open);
}
// Blur of the reflected sky.
FORMULA REAL lathe_sky_roughness(REAL glaze) {
    return mix(0.30F, 0.20F, glaze);
}

// Painted marks: a colour as the square root of light over the body's own, by coverage; a byte of slope given
// as 0 to 1.
FORMULA REAL lathe_marked(REAL own, REAL root, REAL cover) {
    return own + (root * root - own) * cover;
}
FORMULA REAL lathe_mark_lean(REAL fraction, float most) {
    return (fraction - 128.0F / 255.0F) * (255.0F / 127.0F) * most;
}

// Size of the streaks' texture: two widths make a turn, 120 mm each; its height is measured along the
// outline, over the rim and down inside.
CONSTANT float kStreakRoundMm = 120.0F;
CONSTANT float kStreakMm = 67.0F;

#ifdef __cplusplus
}  // namespace onggi::shaders
#endif

#endif

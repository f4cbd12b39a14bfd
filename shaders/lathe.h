// What is turned: a rough body, streaks of fingers, and over it a film of water or a glaze that mirrors.
// Written to be cheap on one core, where a division or a root costs ten multiplications: fractions share a
// division.
#ifndef ONGGI_SHADERS_LATHE_H
#define ONGGI_SHADERS_LATHE_H
#include "formula.h"
#include "surface.h"

#ifdef __cplusplus
namespace onggi::shaders {
#endif

// Marks of the texture of streaks, 0 to 1: lighter or darker; lean round the pot and up it; thickness of the
// film.
FORMULA REAL lathe_tone(REAL streaks, REAL mark) {
    return 1.0F + streaks * (mark - 0.5F) * 1.7F;
}
FORMULA REAL lathe_lean(REAL streaks, REAL mark) {
    return (mark - 0.5F) * streaks;
}
// The film lies thick in some places and thin in others; a glaze covers everything.
FORMULA REAL lathe_film(REAL water, REAL mark, REAL glaze) {
    return max(clamp(water * (0.62F + 1.5F * (mark - 0.5F)), 0.0F, 1.0F), glaze);
}

// `water` in the body fills its roughness; what that takes of the light; its roughness to gloss.
FORMULA REAL lathe_rough(REAL water) {
    return 0.85F - 0.5F * water;
}
FORMULA REAL lathe_left(REAL rough) {
    return 1.0F / (1.0F + 0.288F * rough);
}
FORMULA REAL lathe_roughness(REAL dry, REAL wet, REAL water) {
    return mix(dry, wet, water);
}

// A rough body throws light back towards its source: Y. Fujii's form of the Oren-Nayar model, 2012.
FORMULA REAL fujii_s(REAL l_v, REAL n_l, REAL n_v) {
    return l_v - n_l * n_v;
}
FORMULA REAL fujii_t(REAL s, REAL n_l, REAL n_v) {
    return select(s > 0.0F, max(max(n_l, n_v), 0.1F), 1.0F);
}
// body_sheen: both lobes' denominators; `fraction`: one over that and t.
FORMULA REAL lathe_lit(REAL cosine, REAL rough, REAL s, REAL body_sheen, REAL fraction, REAL left) {
    return max(cosine * (1.0F + 0.9F * rough * s * body_sheen * fraction) * left, 0.0F);
}
// The gleam of the body and that of the film, numerators and denominators; share_t: one over both
// denominators; straight_on: what the film mirrors so.
FORMULA REAL lathe_gloss(REAL body_over, REAL body_under, REAL sheen_over, REAL sheen_under, REAL straight_on,
                         REAL film, REAL fraction_t) {
    return (body_over * sheen_under * (0.04F * kPi) * (1.0F - film) +
            sheen_over * body_under * (straight_on * kPi) * film) *
           fraction_t;
}
// Of the sky.
FORMULA REAL lathe_mirror(REAL straight_on, REAL n_v, REAL film) {
    return (straight_on + (1.0F - straight_on) * 0.7F * grazing(n_v)) * (0.12F + 0.88F * film);
}

// Close to what it stands on, a wall sees less of the sky; n_y: how far it looks up.
FORMULA REAL lathe_open(REAL open, REAL height_mm, REAL n_y, REAL inside) {
    return open * (1.0F - 0.55F * exp_below_0(-height_mm * 0.07F) * (1.0F - n_y) * (1.0F - inside));
}
// Deep inside, what light there is comes down through the mouth, whichever way the wall looks: how far so.
FORMULA REAL lathe_from_mouth(REAL inside, REAL open) {
    return inside * 0.75F * (1.0F - open);
}
// Of what it mirrors of the sky.
FORMULA REAL lathe_sky_roughness(REAL glaze) {
    return mix(0.30F, 0.20F, glaze);
}

// Marks painted on it: a colour as the root of light over the body's own, as far as it covers; a byte of lean
// as a fraction of 1.
FORMULA REAL lathe_marked(REAL own, REAL root, REAL cover) {
    return own + (root * root - own) * cover;
}
FORMULA REAL lathe_mark_lean(REAL fraction, float most) {
    return (fraction - 128.0F / 255.0F) * (255.0F / 127.0F) * most;
}

// Two of the streaks' texture go round, of so many mm each; up the pot one is as long along the outline, over
// the rim and down inside.
CONSTANT float kStreakRoundMm = 120.0F;
CONSTANT float kStreakMm = 67.0F;

#ifdef __cplusplus
}  // namespace onggi::shaders
#endif

#endif

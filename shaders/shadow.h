// What the lathe keeps of the light: from places outside it, and from the ground it stands on.
#ifndef ONGGI_SHADERS_SHADOW_H
#define ONGGI_SHADERS_SHADOW_H
#include "formula.h"

#ifdef __cplusplus
namespace onggi::shaders {
#endif

// Towards the light from a place, through the slab of height that the lathe fills: where it begins.
FORMULA REAL slab_from(REAL y, REAL rise) {
    return max(-y / rise, 0.0F);
}
FORMULA REAL slab_to(REAL y, REAL rise, REAL height) {
    return (height - y) / rise;
}
// How far past the outline a ray is after t mm, as an angle.
FORMULA REAL past_outline(REAL x, REAL z, REAL outline_mm, REAL t) {
    return (sqrt(x * x + z * z) - outline_mm) / max(t, 4.0F);
}
// How much of a light of this half width gets by, whose rays come so near.
FORMULA REAL past_least(REAL least, REAL half_width) {
    REAL width = max(half_width, 0.02F);
    return smoothstep(-width, width, least);
}

// The ground: the shade of the lathe by steps up a ray (see FrameData::shadow_steps), in widths of penumbra,
FORMULA REAL ground_gap(VEC4 at, REAL x, REAL z) {
    REAL dx = x + at.x;
    REAL dz = z + at.y;
    return (sqrt(dx * dx + dz * dz) - at.z) * at.w;
}
FORMULA REAL ground_lit(REAL least_gap) {
    return smoothstep(-1.0F, 1.0F, least_gap);
}
// what of the sky the foot leaves beside it,
FORMULA REAL ground_open(REAL from_foot_mm) {
    REAL shade = 0.55F * exp_below_0(-from_foot_mm * 0.09F) + 0.27F * exp_below_0(-from_foot_mm * 0.024F);
    return 1.0F - shade * (1.0F - smoothstep(18.0F, 62.0F, from_foot_mm));
}
// and 0 at the mask's border, 1 a little inside: there nothing is in shade, so that a lookup outside finds
// the border and is right.
FORMULA REAL inside_mask(REAL u, REAL v) {
    REAL across = min(u, 1.0F - u) * 8.0F;
    REAL down = min(v, 1.0F - v) * 8.0F;
    return smoothstep(0.1F, 1.0F, min(across, down));
}

#ifdef __cplusplus
}  // namespace onggi::shaders
#endif

#endif

// The lathe's shadow on points outside it, and on the ground that it stands on.
#ifndef ONGGI_SHADERS_SHADOW_H
#define ONGGI_SHADERS_SHADOW_H
#include "formula.h"

#ifdef __cplusplus
namespace onggi::shaders {
#endif

// Range of a ray towards the light within the lathe's range of heights, in mm from the point.
FORMULA REAL slab_from(REAL y, REAL rise) {
    return max(-y / rise, 0.0F);
}
FORMULA REAL slab_to(REAL y, REAL rise, REAL height) {
    return (height - y) / rise;
}
// Clearance of a ray from the outline after t mm, as an angle.
FORMULA REAL past_outline(REAL x, REAL z, REAL outline_mm, REAL t) {
    return (sqrt(x * x + z * z) - outline_mm) / max(t, 4.0F);
}
// Visible fraction of a light of this half width, given the ray's smallest clearance.
FORMULA REAL past_least(REAL least, REAL half_width) {
    REAL width = max(half_width, 0.02F);
    return smoothstep(-width, width, least);
}

// The ground: clearance of the lathe at one step of a ray (see FrameData::shadow_steps), in penumbra widths.
FORMULA REAL ground_gap(VEC4 at, REAL x, REAL z) {
    REAL dx = x + at.x;
    REAL dz = z + at.y;
    return (sqrt(dx * dx + dz * dz) - at.z) * at.w;
}
FORMULA REAL ground_lit(REAL least_gap) {
    return smoothstep(-1.0F, 1.0F, least_gap);
}
// Fraction of the sky that the foot leaves visible beside it.
FORMULA REAL ground_open(REAL from_foot_mm) {
    REAL shade = 0.55F * exp_below_0(-from_foot_mm * 0.09F) + 0.27F * exp_below_0(-from_foot_mm * 0.024F);
    return 1.0F - shade * (1.0F - smoothstep(18.0F, 62.0F, from_foot_mm));
}
// 0 at the mask's border, 1 a little inside. The border is therefore never in shade, and lookups outside the
// mask, which are clamped to the border, are correct.
FORMULA REAL inside_mask(REAL u, REAL v) {
    REAL across = min(u, 1.0F - u) * 8.0F;
    REAL down = min(v, 1.0F - v) * 8.0F;
    return smoothstep(0.1F, 1.0F, min(across, down));
}

#ifdef __cplusplus
}  // namespace onggi::shaders
#endif

#endif

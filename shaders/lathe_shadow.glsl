// The lathe's shadow on points outside it, see shadow.h.
#include "shadow.h"

layout(std430, set = 0, binding = kBindOutline) readonly buffer OutlineBlock {
    float outline[];
};

// Fraction of the key light that reaches p, 0 to 1, from the smallest angle between ray and outline in units
// of the light's half width. Marches sixteen steps through the lathe's range of heights; for vertices, not
// for pixels.
float past_lathe_to_light(vec3 p) {
    float height = frame.lathe.x;
    if (height <= 0.0) return 1.0;
    vec3 l = frame.key_direction.xyz;
    float rise = max(l.y, 0.05);
    float from = slab_from(p.y, rise);
    float to = slab_to(p.y, rise, height);
    if (to <= from) return 1.0;
    float least = 1e3;
    const int kSteps = 16;
    for (int i = 0; i < kSteps; ++i) {
        float t = mix(from, to, (float(i) + 0.5) / float(kSteps));
        vec3 at = p + l * t;
        float sample_number = clamp(at.y * frame.lathe.y, 0.0, frame.lathe.z - 1.0);
        vec2 from_axis = at.xz - frame.lathe_foot.xy;
        least = min(least, past_outline(from_axis.x, from_axis.y, outline[int(sample_number)], t));
    }
    return past_least(least, frame.key_direction.w);
}

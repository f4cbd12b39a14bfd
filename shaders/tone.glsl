// Encodes light in eight bits: the tone curve, then the screen's transfer function.
#include "curve.h"
#include "transfer.h"

// The three fractions n / d with one division.
vec3 divided(vec3 n, vec3 d) {
    return n * d.yzx * d.zxy / (d.x * d.y * d.z);
}

vec3 encode(vec3 light) {
    vec3 c = max(light, vec3(0.0));
    c = min(divided(c, curve_under(c)), vec3(1.0));
    return vec3(transferred(c.r), transferred(c.g), transferred(c.b));
}

// The inverse of encode().
vec3 decode(vec3 v) {
    return curve_light(vec3(untransferred(v.r), untransferred(v.g), untransferred(v.b)));
}

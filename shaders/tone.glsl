// Light to eight bits: the picture's curve, then the transfer function of the screen.
#include "curve.h"

layout(constant_id = 0) const uint kTransfer = 0;  // 0 exact sRGB (IEC 61966-2-1), 1 square root

// The three fractions n / d with one division.
vec3 divided(vec3 n, vec3 d) {
    return n * d.yzx * d.zxy / (d.x * d.y * d.z);
}

// 0 to 1 to the values of the screen.
vec3 transferred(vec3 c) {
    c = min(c, vec3(1.0));
    if (kTransfer == 1) return sqrt(c);
    return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, c * 12.92, lessThanEqual(c, vec3(0.0031308)));
}
vec3 untransferred(vec3 v) {
    if (kTransfer == 1) return v * v;
    return mix(pow((v + 0.055) / 1.055, vec3(2.4)), v / 12.92, lessThanEqual(v, vec3(0.04045)));
}

vec3 encode(vec3 light) {
    vec3 c = max(light, vec3(0.0));
    return transferred(divided(c, curve_under(c)));
}

// encode() backwards.
vec3 decode(vec3 v) {
    return curve_light(untransferred(v));
}

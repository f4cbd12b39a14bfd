// Light to eight bits: a rational curve that never clips, then the transfer function of the screen.
layout(constant_id = 0) const uint kTransfer = 0;  // 0 exact sRGB (IEC 61966-2-1), 1 square root

vec3 encode(vec3 light) {
    vec3 c = max(light, vec3(0.0));
    c = c / (c * 0.8 + 0.35);
    if (kTransfer == 1) return sqrt(min(c, vec3(1.0)));
    c = min(c, vec3(1.0));
    return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, c * 12.92, lessThanEqual(c, vec3(0.0031308)));
}

// The curve backwards; white, where it is steepest, is light of 1.75.
vec3 light_of(vec3 c) {
    return 0.35 * c / (1.0 - 0.8 * c);
}

// encode() backwards.
vec3 decode(vec3 v) {
    if (kTransfer == 1) return light_of(v * v);
    return light_of(mix(pow((v + 0.055) / 1.055, vec3(2.4)), v / 12.92, lessThanEqual(v, vec3(0.04045))));
}

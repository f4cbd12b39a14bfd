// Smooth noise from hashed integers, which is the same on every device.
float hashed(ivec3 cell) {
    uvec3 k = uvec3(cell) * uvec3(0x9E3779B1u, 0x85EBCA77u, 0xC2B2AE3Du);
    uint h = k.x ^ k.y ^ k.z;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    h = (h ^ (h >> 12)) * 0x297A2D39u;
    return float((h ^ (h >> 15)) >> 8) * (1.0 / 16777216.0);
}

float value_noise(vec3 p) {
    vec3 base = floor(p);
    ivec3 c = ivec3(base);
    vec3 t = p - base;
    t = t * t * (3.0 - 2.0 * t);
    vec4 low =
        vec4(hashed(c), hashed(c + ivec3(1, 0, 0)), hashed(c + ivec3(0, 1, 0)), hashed(c + ivec3(1, 1, 0)));
    vec4 high = vec4(hashed(c + ivec3(0, 0, 1)), hashed(c + ivec3(1, 0, 1)), hashed(c + ivec3(0, 1, 1)),
                     hashed(c + ivec3(1, 1, 1)));
    vec4 z = mix(low, high, t.z);
    vec2 y = mix(z.xy, z.zw, t.y);
    return mix(y.x, y.y, t.x);
}

// Up to half an eight-bit level up or down, constant per pixel: prevents banding in gradients.
vec3 dither() {
    return vec3((hashed(ivec3(gl_FragCoord.xy, 11)) - 0.5) / 255.0);
}

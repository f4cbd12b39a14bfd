// Packs two 16-bit numbers, 0 to 1, into the four bytes of a texel: llvmpipe reads eight-bit texels several
// times as fast as sixteen-bit ones.
vec4 packed16(vec2 numbers) {
    vec2 whole = floor(clamp(numbers, 0.0, 1.0) * 65535.0 + 0.5);
    vec2 high = floor(whole * (1.0 / 256.0));
    vec2 low = whole - high * 256.0;
    return vec4(high.x, low.x, high.y, low.y) * (1.0 / 255.0);
}

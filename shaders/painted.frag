#version 460
// A pixel of an overlay that the processor has painted, in the target's own order of bytes, already encoded
// for the screen and multiplied by alpha.
layout(constant_id = 0) const uint kBlueFirst = 0;
layout(set = 0, binding = 0) readonly buffer Painted {
    uint painted[];
};
layout(push_constant) uniform Push {
    vec2 clip_per_px;
    uint width_px;
};
layout(location = 0) out vec4 result;

void main() {
    uvec2 at = uvec2(gl_FragCoord.xy);
    vec4 pixel = unpackUnorm4x8(painted[at.y * width_px + at.x]);
    result = kBlueFirst != 0 ? pixel.bgra : pixel;
}

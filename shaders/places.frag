#version 460
#extension GL_GOOGLE_include_directive : require
// Where the shadow mask is to be read for a pixel of a photographed room, and how much the foot's shade counts
// there. The colours are the photographs'.
#include "frame.glsl"
#include "packed.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 0) out vec4 out_foot;    // alpha, as the layer without the key light has it
layout(location = 1) out vec4 out_coords;  // as in mesh.frag

void main() {
    vec2 uv = vec2(dot(frame.mask_u.xyz, position) + frame.mask_u.w,
                   dot(frame.mask_v.xyz, position) + frame.mask_v.w);
    out_foot = vec4(0.0, 0.0, 0.0, smoothstep(-7.0, -1.0, position.y) * max(normal.y, 0.0));
    out_coords = packed16(uv);
}

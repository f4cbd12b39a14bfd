#version 460
#extension GL_GOOGLE_include_directive : require
// For a photographed room: each pixel's coordinates in the shadow mask, and the weight of the foot's shade.
// The colours come from the photographs.
#include "frame.glsl"
#include "packed.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 0) out vec4 out_foot;    // alpha, as in the layer without the key light
layout(location = 1) out vec4 out_coords;  // as in mesh.frag

void main() {
    vec2 uv = vec2(dot(frame.mask_u.xyz, position) + frame.mask_u.w,
                   dot(frame.mask_v.xyz, position) + frame.mask_v.w);
    out_foot = vec4(0.0, 0.0, 0.0, smoothstep(-7.0, -1.0, position.y) * max(normal.y, 0.0));
    out_coords = packed16(uv);
}

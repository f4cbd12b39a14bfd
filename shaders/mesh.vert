#version 460
#extension GL_GOOGLE_include_directive : require
// A still mesh or a moving sphere, into the picture.
#include "frame.glsl"

layout(push_constant) uniform DrawBlock { MeshDraw draw; };
layout(location = 0) in vec3 position_mm;
layout(location = 1) in vec3 normal;
layout(location = 2) in float open_sky;
layout(location = 0) out vec3 out_position;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out float out_open_sky;

void main() {
    out_position = draw.place.xyz + draw.place.w * position_mm;
    out_normal = normal;
    out_open_sky = open_sky;
    gl_Position = frame.view_projection * vec4(out_position, 1.0);
}

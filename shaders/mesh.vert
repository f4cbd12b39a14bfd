#version 460
#extension GL_GOOGLE_include_directive : require
// A static mesh; with ONGGI_BACKGROUND, one that only carries photographs.
#include "frame.glsl"

layout(push_constant) uniform DrawBlock {
    MeshDraw draw;
};
layout(location = 0) in vec3 position_mm;
layout(location = 1) in vec3 normal;
#ifndef ONGGI_BACKGROUND
layout(location = 2) in float open_sky;
layout(location = 2) out float out_open_sky;
#endif
layout(location = 0) out vec3 out_position;
layout(location = 1) out vec3 out_normal;

void main() {
    out_position = draw.place.xyz + position_mm;
    out_normal = normal;
#ifndef ONGGI_BACKGROUND
    out_open_sky = open_sky;
#endif
    gl_Position = frame.view_projection * vec4(out_position, 1.0);
}

#version 460
#extension GL_GOOGLE_include_directive : require
// The still life as seen by the key light: depth only.
#include "frame.glsl"

layout(push_constant) uniform DrawBlock {
    MeshDraw draw;
};
layout(location = 0) in vec3 position_mm;

void main() {
    gl_Position = frame.key_view_projection * vec4(draw.place.xyz + position_mm, 1.0);
}

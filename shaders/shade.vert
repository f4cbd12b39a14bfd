#version 460
#extension GL_GOOGLE_include_directive : require
// The rectangles that the shade can reach.
#include "frame.glsl"

layout(push_constant) uniform DrawBlock {
    ShadeDraw draw;
};

void main() {
    vec4 rect = draw.rects[gl_VertexIndex / 6];
    const int kCorners[6] = {0, 1, 2, 2, 1, 3};
    int corner = kCorners[gl_VertexIndex % 6];
    vec2 at = vec2((corner & 1) != 0 ? rect.z : rect.x, (corner & 2) != 0 ? rect.w : rect.y);
    gl_Position = vec4(at * frame.picture.zw * 2.0 - 1.0, 0.0, 1.0);
}

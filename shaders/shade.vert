#version 460
#extension GL_GOOGLE_include_directive : require
// The rectangles that the shade can reach.
#include "frame.glsl"

layout(push_constant) uniform DrawBlock {
    ShadeDraw draw;
};

layout(location = 0) out vec2 out_at;  // in the picture, 0 to 1

void main() {
    vec4 rect = draw.rects[gl_VertexIndex / 6];
    const int kCorners[6] = {0, 1, 2, 2, 1, 3};
    int corner = kCorners[gl_VertexIndex % 6];
    vec2 at = vec2((corner & 1) != 0 ? rect.z : rect.x, (corner & 2) != 0 ? rect.w : rect.y);
    out_at = at * frame.picture.zw;
    gl_Position = vec4(out_at * 2.0 - 1.0, 0.0, 1.0);
}

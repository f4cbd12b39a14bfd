#version 460
#extension GL_GOOGLE_include_directive : require
// The convex polygon that the shade can reach, as a fan of triangles.
#include "frame_data.h"

layout(push_constant) uniform DrawBlock { ShadeDraw draw; };

vec2 corner(int number) {
    vec4 two = draw.corners[number / 2];
    return (number & 1) == 0 ? two.xy : two.zw;
}

void main() {
    int triangle = gl_VertexIndex / 3;
    int place = gl_VertexIndex - 3 * triangle;
    gl_Position = vec4(corner(place == 0 ? 0 : triangle + place), 0.0, 1.0);
}

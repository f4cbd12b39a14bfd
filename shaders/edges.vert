#version 460
#extension GL_GOOGLE_include_directive : require
// A thin strip along a piece of an outline: wide enough for every pixel whose centre lies within half a pixel
// of the line, across it along the axis it is steeper to.
#include "frame.glsl"

layout(std430, set = 0, binding = kBindEdges) readonly buffer EdgeBlock {
    EdgeData edges[];
};

layout(location = 1) flat out vec2 out_per_px;  // one over the picture's size
layout(location = 0) flat out vec4 out_line;  // a point of it, its slope, 1 if it runs mostly across

void main() {
    EdgeData edge = edges[gl_VertexIndex / 6];
    const int kCorners[6] = {0, 1, 2, 2, 1, 3};
    int corner = kCorners[gl_VertexIndex % 6];
    vec2 along = edge.to.xy - edge.from.xy;
    bool level = abs(along.x) > abs(along.y);
    // A quarter of a pixel further at both ends, so that pieces that turn a corner leave no pixel out.
    vec2 step = along / max(max(abs(along.x), abs(along.y)), 1e-4) * 0.25;
    bool at_end = (corner & 1) != 0;
    vec2 at = (at_end ? edge.to.xy + step : edge.from.xy - step);
    float side = (corner & 2) != 0 ? 0.75 : -0.75;
    at += level ? vec2(0.0, side) : vec2(side, 0.0);
    out_per_px = frame.picture.zw;
    out_line = vec4(edge.from.xy, level ? along.y / along.x : along.x / along.y, level ? 1.0 : 0.0);
    gl_Position = vec4(at * frame.picture.zw * 2.0 - 1.0, at_end ? edge.to.z : edge.from.z, 1.0);
}

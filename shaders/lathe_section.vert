#version 460
#extension GL_GOOGLE_include_directive : require
// The cut faces of a wall.
#include "frame.glsl"

layout(std430, set = 0, binding = kBindVertices) readonly buffer VertexBlock {
    VertexData vertices[];
};

// Mm from the axis and up; load; 0 to 1 from the outer to the inner face.
layout(location = 0) out vec4 out_place;

void main() {
    VertexData vertex = vertices[gl_VertexIndex];
    out_place = vec4(vertex.lean.x, vertex.place.y, vertex.lean.y, vertex.lean.z);
    gl_Position = frame.view_projection * vec4(vertex.place.xyz, 1.0);
}

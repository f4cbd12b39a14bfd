#version 460
// A thin strip along a piece of an outline, placed by the processor (outline_strips.h).

layout(location = 0) in vec3 at;    // in the device's own coordinates
layout(location = 1) in vec4 line;  // a point of it in pixels, its slope, 1 if it runs mostly across
layout(location = 0) flat out vec4 out_line;

void main() {
    out_line = line;
    gl_Position = vec4(at, 1.0);
}

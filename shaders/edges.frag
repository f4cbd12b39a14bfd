#version 460
#extension GL_GOOGLE_include_directive : require
// Smooths an outline: where the line passes through a pixel, the pixel's other part belongs to what lies on
// the line's other side, which is its neighbour there. How much is known from the line itself, exactly; two
// reads. Geometric anti-aliasing after E. Persson, "Geometric Post-process Anti-Aliasing", 2011; here from
// the mesh's own outline, so that nothing is looked for in the picture.
#include "frame_data.h"

layout(set = 0, binding = kBindPicture) uniform sampler2D picture;

layout(location = 0) flat in vec4 line;
layout(location = 0) out vec4 out_colour;

void main() {
    vec2 from = gl_FragCoord.xy - line.xy;
    bool level = line.w > 0.5;
    // From the line to the pixel's centre, along the axis the strip is wide in.
    float off = level ? from.y - line.z * from.x : from.x - line.z * from.y;
    float other = 0.5 - abs(off);
    if (other <= 0.0) discard;
    float towards = off > 0.0 ? -1.0 : 1.0;
    ivec2 at = ivec2(gl_FragCoord.xy);
    ivec2 beside = level ? ivec2(0, int(towards)) : ivec2(int(towards), 0);
    vec3 own = texelFetch(picture, at, 0).rgb;
    vec3 beyond = texelFetch(picture, at + beside, 0).rgb;
    out_colour = vec4(mix(own, beyond, other), 1.0);
}

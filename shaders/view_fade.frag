#version 460
#extension GL_GOOGLE_include_directive : require
// The last picture of the previous view, laid over the new view after a cut.
#include "frame.glsl"

layout(set = 0, binding = kBindViewBefore) uniform sampler2D view_before;

layout(location = 0) in vec2 place;  // 0 to 1 from the top left
layout(location = 0) out vec4 out_colour;

void main() {
    float left = frame.fade.x;
    out_colour = vec4(texelFetch(view_before, ivec2(place * frame.picture.xy), 0).rgb * left, left);
}

#version 460
#extension GL_GOOGLE_include_directive : require
// The cut faces of a wall, as a drawing has them: pale, hatched at 45 degrees, with a line where they end. A
// longer line of the hatch every ten millimetres of height is a scale. section_pixels.cpp of engine/render is
// the same in C++.
#include "frame.glsl"
#include "load.glsl"
#include "tone.glsl"

layout(push_constant) uniform DrawBlock {
    LatheDraw draw;
};
layout(location = 0) in vec4 place;
layout(location = 0) out vec4 out_colour;

void main() {
    vec3 colour = draw.dry.rgb;
    float lines = abs(fract((place.x + place.y) / 3.0) - 0.5);
    float width = fwidth((place.x + place.y) / 3.0);
    colour *= 1.0 - 0.30 * smoothstep(0.12 + width, 0.12, lines);
    if (draw.wet.w > 0.5) colour = with_load(colour, place.z, place.x + place.y);
    float border = min(place.w, 1.0 - place.w);
    colour *= mix(0.25, 1.0, smoothstep(0.0, 1.5 * fwidth(place.w), border));
    float mark = abs(place.y - 10.0 * round(place.y * 0.1));
    colour *= mix(0.35, 1.0, smoothstep(0.5, 1.5, mark / max(fwidth(place.y), 1e-4)));
    out_colour = vec4(encode(colour), 1.0);
}

#version 460
#extension GL_GOOGLE_include_directive : require
// The cut faces of a wall, drawn like a technical section, see load.h.
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
    float along = place.x + place.y;
    colour *= section_hatch(along, fwidth(along));
    if (draw.wet.w > 0.5) colour = with_load(colour, place.z, along);
    colour *= section_border(place.w, fwidth(place.w)) * section_scale(place.y, fwidth(place.y));
    out_colour = vec4(encode(colour), 1.0);
}

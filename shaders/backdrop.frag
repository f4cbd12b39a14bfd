#version 460
#extension GL_GOOGLE_include_directive : require
// The wall behind everything.
#include "frame.glsl"
#include "noise.glsl"
#include "packed.glsl"
#include "tone.glsl"

layout(location = 0) in vec2 position;
layout(location = 0) out vec4 out_colour;
#ifdef ONGGI_LAYERS
layout(location = 1) out vec4 out_ambient;
layout(location = 2) out vec4 out_coords;
#endif

void main() {
    vec2 at = vec2(position.x * 2.0 - 1.0, 1.0 - position.y * 2.0) * frame.backdrop_shape.zw;
    float height = clamp(0.5 + 0.5 * (1.0 - position.y * 2.0), 0.0, 1.0);
    vec2 from_glow = (at - frame.backdrop_shape.xy) / frame.backdrop_glow.w;
    vec3 light = mix(frame.backdrop_low.rgb, frame.backdrop_high.rgb, height) +
                 frame.backdrop_glow.rgb * exp(-dot(from_glow, from_glow));
    vec4 colour = vec4(encode(light) + dither(), 1.0);
    out_colour = colour;
#ifdef ONGGI_LAYERS
    out_ambient = vec4(colour.rgb, 0.0);
    out_coords = vec4(0.0);  // the mask's corner, where nothing is in shade
#endif
}

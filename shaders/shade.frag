#version 460
#extension GL_GOOGLE_include_directive : require
// Lays the moving things' shadow over the cached still life: between the picture with the key light and the
// one without it. Only over the few pixels that the shadow can reach.
#include "frame.glsl"

layout(set = 0, binding = kBindMask) uniform sampler2D shadow_mask;
layout(set = 0, binding = kBindStillKey) uniform sampler2D still_key;
layout(set = 0, binding = kBindStillAmbient) uniform sampler2D still_ambient;
layout(set = 0, binding = kBindStillCoords) uniform sampler2D still_coords;

layout(location = 0) out vec4 out_colour;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 coords = texelFetch(still_coords, pixel, 0).rgb;
    vec2 mask = texture(shadow_mask, coords.rg).rg;
    vec3 with_key = texelFetch(still_key, pixel, 0).rgb;
    vec3 without_key = texelFetch(still_ambient, pixel, 0).rgb;
    out_colour = vec4(mix(without_key, with_key, mask.r) * mix(1.0, mask.g, coords.b), 1.0);
}

#version 460
#extension GL_GOOGLE_include_directive : require
// Lays the moving things' shadow over the cached still life: between the picture with the key light and the
// one without it. Only over the few pixels that the shadow can reach.
#include "frame_data.h"
#include "packed.glsl"
#include "tone.glsl"

layout(set = 0, binding = kBindMask) uniform sampler2D shadow_mask;
layout(set = 0, binding = kBindStillKey) uniform sampler2D still_key;
layout(set = 0, binding = kBindStillAmbient) uniform sampler2D still_ambient;
layout(set = 0, binding = kBindStillCoords) uniform sampler2D still_coords;

layout(location = 0) in vec2 at;
layout(location = 0) out vec4 out_colour;

void main() {
    // At the texel's own centre, through samplers that take the nearest: llvmpipe is quicker at that than at
    // texelFetch.
    vec2 mask = texture(shadow_mask, unpacked16(texture(still_coords, at))).rg;
    vec4 without_key = texture(still_ambient, at);
    vec3 with_key = texture(still_key, at).rgb;
    // In light, not in eight bits: the penumbra's colour would be wrong.
    out_colour = vec4(
        encode_mixed(without_key.rgb, with_key, mask.r, mix(1.0, mask.g, without_key.a)), 1.0);
}

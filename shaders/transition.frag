#version 460
#extension GL_GOOGLE_include_directive : require
// See glide.vert. Shadows are mixed in the values of the screen here, not in light: right in the umbra and
// outside it, and nobody studies a penumbra while the camera moves.
#include "frame.glsl"
#include "transition.glsl"
#include "background_edge.glsl"
#include "tone.glsl"

layout(set = 0, binding = kBindMask) uniform sampler2D shadow_mask;
layout(set = 0, binding = kBindBackgroundKey) uniform sampler2D from_key;
layout(set = 0, binding = kBindBackgroundAmbient) uniform sampler2D from_ambient;
layout(set = 0, binding = kBindNextKey) uniform sampler2D to_key;
layout(set = 0, binding = kBindNextAmbient) uniform sampler2D to_ambient;

layout(location = 0) in vec4 from;
#ifdef ONGGI_SURFACE
layout(location = 1) in vec3 mask_at;
#else
layout(location = 1) in float seen;
#endif
layout(location = 2) in vec3 to;
layout(location = 0) out vec4 out_colour;

void main() {
    vec2 from_at = from.xy / from.z;
    vec2 to_at = kMixes ? to.xy / to.z : vec2(0.0);
    vec3 lit = texture(from_key, mirrored(from_at)).rgb;
    if (kMixes) lit = mix(lit, texture(to_key, mirrored(to_at)).rgb, from.w);
#ifdef ONGGI_SURFACE
    vec3 unlit = texture(from_ambient, mirrored(from_at)).rgb;
    if (kMixes) unlit = mix(unlit, texture(to_ambient, mirrored(to_at)).rgb, from.w);
    vec2 mask = texture(shadow_mask, mask_at.xy).rg;
    // A fraction of the light is its root in the values of the screen, where they are dark.
    vec3 value = mix(unlit, lit, mask.r) * sqrt(mix(1.0, mask.g, mask_at.z));
#else
    // Out on the deck the room without the key light is about this much darker.
    const vec3 kWithoutKey = vec3(0.50, 0.53, 0.58);
    vec3 value = lit * mix(kWithoutKey, vec3(1.0), seen);
#endif
    value *= kMixes ? mix(left_beside(from_at), left_beside(to_at), from.w) : left_beside(from_at);
    if (kDims) value = encode(decode(value) * mix(frame.levels.rgb, vec3(frame.levels.w), 0.6));
    out_colour = vec4(value, 1.0);
}

#version 460
#extension GL_GOOGLE_include_directive : require
// The still life, from two photographs with and without the key light. With ONGGI_SURFACE it is drawn on a
// mesh, which gives the pixel's place in the world; without, it fills the rest of the picture.
#include "frame.glsl"
#include "noise.glsl"
#include "background_edge.glsl"
#include "tone.glsl"

layout(set = 0, binding = kBindMask) uniform sampler2D shadow_mask;
// Both encoded like the target.
layout(set = 0, binding = kBindBackgroundKey) uniform sampler2D background_key;
layout(set = 0, binding = kBindBackgroundAmbient) uniform sampler2D background_ambient;

#ifdef ONGGI_SURFACE
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
#else
layout(location = 0) in vec2 place;  // 0 to 1 from the top left
#endif
layout(location = 0) out vec4 out_colour;

void main() {
#ifdef ONGGI_SURFACE
    vec2 pixel = gl_FragCoord.xy;
#else
    vec2 pixel = place * frame.picture.xy;
#endif
    vec2 at = pixel * frame.background_window.xy + frame.background_window.zw;
    vec3 all_light = decode(texture(background_key, mirrored(at)).rgb);
    vec3 ambient = decode(texture(background_ambient, mirrored(at)).rgb);
    float left = left_beside(at);
    left *= left;
    // Compression may leave the lit photograph darker by one level.
    vec3 key_light = max(all_light - ambient, vec3(0.0)) * (frame.levels.w * left);
    ambient *= frame.levels.rgb * left;
#ifdef ONGGI_SURFACE
    vec2 uv = vec2(dot(frame.mask_u.xyz, position) + frame.mask_u.w,
                   dot(frame.mask_v.xyz, position) + frame.mask_v.w);
    float near_foot = smoothstep(-7.0, -1.0, position.y) * max(normal.y, 0.0);
#else
    vec2 uv = vec2(0.0);  // the mask's corner, where nothing is in shade
    float near_foot = 0.0;
#endif
    vec2 mask = texture(shadow_mask, uv).rg;
    vec3 light = (ambient + key_light * mask.r) * mix(1.0, mask.g, near_foot);
    out_colour = vec4(encode(light) + dither(), 1.0);
}

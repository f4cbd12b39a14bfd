#version 460
#extension GL_GOOGLE_include_directive : require
// Thrown clay: a rough body with the outline's own normal at every pixel, slip streaks that turn with it, and
// over it a film of water or a glaze that mirrors. Written to be cheap on one core, where a division or a root
// costs ten multiplications, and a number of a uniform buffer thirty: what changes slowly or not at all comes
// from the vertices, and fractions share a division. lathe_shade.h of engine/render is the same in C++, for a
// device that is the processor: a change here is one there, or paths_agree_test.cpp fails.
#include "frame_data.h"
#include "surface.glsl"
#ifdef ONGGI_LOAD
#include "load.glsl"
#endif
#include "tone.glsl"

layout(set = 0, binding = kBindNormals) uniform usamplerBuffer outline_normals;
layout(set = 0, binding = kBindSlip) uniform usamplerBuffer slip_texels;
layout(set = 0, binding = kBindDetail) uniform sampler2D detail;
layout(constant_id = 1) const bool kNearSpheres = true;  // where their shadow may fall
layout(constant_id = 2) const int kSlipAcross = 512;     // texels, powers of two
layout(constant_id = 3) const int kSlipUp = 512;

layout(location = 0) in vec3 to_eye;
layout(location = 1) in vec4 outline;
layout(location = 2) in vec4 detail_at;
layout(location = 3) in vec4 ambient;
layout(location = 4) in vec4 mirrored;
layout(location = 5) in vec4 body_albedo;
layout(location = 6) in vec2 slow;
layout(location = 7) flat in vec4 light_from;
layout(location = 8) flat in vec4 radiance;
layout(location = 9) flat in vec4 gloss_of;
layout(location = 10) flat in vec4 eye;
layout(location = 11) flat in vec4 spheres[kSpheres];
#ifdef ONGGI_LOAD
layout(location = 15) in vec2 load;
#endif
layout(location = 16) noperspective in float slip_up;  // as detail_at.y, so that it grows evenly over a triangle
layout(location = 0) out vec4 out_colour;

const float kPi = 3.14159265;

vec2 from_sixteen_bits(uint word) {
    return vec2(int(word & 0xFFFFu), int(word >> 16)) * (1.0 / 65535.0);
}

// r: lighter or darker; g, b: lean round the pot and up it; a: thickness of the film. Live on a processor by one
// texel, which is about as large as a pixel there: four cost three times as much. It is a word of a buffer, whose
// place takes fewer steps to find than a texel's in an image. Where a wall is seen so slantwise that several texels
// lie under a pixel, the mean of some above one another: one of the levels of detail_texture.h.
vec4 slip_at(vec2 place) {
    if (kTransfer != 1) return texture(detail, place);
    ivec2 texel = ivec2(floor(place * vec2(kSlipAcross, kSlipUp))) & ivec2(kSlipAcross - 1, kSlipUp - 1);
    float a_pixel = fwidth(slip_up) * float(kSlipUp);
    int level = int(a_pixel > 1.5) + int(a_pixel > 3.0) + int(a_pixel > 6.0);
    uint bytes = texelFetch(slip_texels, (level * kSlipUp + texel.y) * kSlipAcross + texel.x).r;
    return vec4(ivec4(uvec4(bytes) >> uvec4(0, 8, 16, 24) & 255u)) * (1.0 / 255.0);
}

void main() {
    vec3 l = light_from.xyz;
    int texel = clamp(int(outline.z * float(kProfileTexels)), 0, kProfileTexels - 1);
    vec2 profile = from_sixteen_bits(texelFetch(outline_normals, texel).r) * 2.0 - 1.0;
    vec4 slip = slip_at(detail_at.xy);
    float streaks = gloss_of.x;
    vec2 lean = (slip.gb - 0.5) * streaks;
    vec2 outward = outline.xy;
    // Dents and slip lean the wall; between two sectors the way outwards is a chord, a little shorter than 1.
    vec3 n = normalize(vec3(profile.x * outward.x - lean.x * outward.y,
                            profile.y - profile.x * detail_at.w + lean.y,
                            profile.x * outward.y + lean.x * outward.x));

    vec3 v = to_eye * slow.x;
    float n_l = dot(n, l);
    float n_v = max(dot(n, v), 0.05);
    float l_v = dot(l, v);
    vec3 albedo = body_albedo.rgb * (1.0 + streaks * (slip.r - 0.5) * 1.7);
#ifdef ONGGI_LOAD
    albedo = with_load(albedo, load.x, load.y);
#endif
    float seen = outline.w;
    if (kNearSpheres) {
        vec3 position = eye.xyz - to_eye;
        seen *= past_sphere(spheres[0], l, eye.w, position) * past_sphere(spheres[1], l, eye.w, position) *
                past_sphere(spheres[2], l, eye.w, position) * past_sphere(spheres[3], l, eye.w, position);
    }

    // Rough clay throws light back towards its source: Y. Fujii's form of the Oren-Nayar model (2012). Water
    // fills the roughness.
    float s = l_v - n_l * n_v;
    float t = s > 0.0 ? max(max(n_l, n_v), 0.1) : 1.0;

    // The half vector is (v + l) over its length, so its cosines need no vector of their own.
    float n_h = max((n_v + n_l) * slow.y, 0.0);
    float light_l = max(n_l, 0.0);
    vec2 body = ggx_fraction(n_h, n_v, light_l, ambient.w);
    // The film lies thick in some places and thin in others; a glaze covers everything.
    float film = max(clamp(detail_at.z * (0.62 + 1.5 * (slip.a - 0.5)), 0.0, 1.0), gloss_of.z);
    vec2 sheen = ggx_fraction(n_h, n_v, light_l, gloss_of.y);
    float mirror = gloss_of.w + (1.0 - gloss_of.w) * 0.7 * fresnel(0.0, n_v);

    float body_sheen = body.y * sheen.y;
    float share = 1.0 / (body_sheen * t);
    float lit = soft_cosine(n_l, light_from.w, radiance.w) *
                (1.0 + 0.9 * mirrored.w * s * body_sheen * share) * body_albedo.w;
    float gloss =
        (body.x * sheen.y * (0.04 * kPi) * (1.0 - film) + sheen.x * body.y * (gloss_of.w * kPi) * film) *
        (share * t);

    vec3 light = albedo * (ambient.rgb + radiance.rgb * (max(lit, 0.0) * seen)) +
                 radiance.rgb * (gloss * seen) + mirrored.rgb * (mirror * (0.12 + 0.88 * film));
    out_colour = vec4(encode(light), 1.0);
}

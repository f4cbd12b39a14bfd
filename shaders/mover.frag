#version 460
#extension GL_GOOGLE_include_directive : require
// A hand or a tool: soft light on flesh, cloth and wood, a wet gleam where clay lies on it.
#include "frame.glsl"
#include "surface.glsl"
#include "tone.glsl"

layout(push_constant) uniform DrawBlock {
    MoverDraw draw;
};
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 albedo;
layout(location = 3) in vec3 ambient;
layout(location = 4) in float key;
layout(location = 0) out vec4 out_colour;

void main() {
    vec3 n = normalize(normal);
    vec3 v = normalize(frame.eye.xyz - position);
    vec3 l = frame.key_direction.xyz;
    float n_l = dot(n, l);
    float n_v = max(dot(n, v), 0.05);
    // Light scatters under skin and in cloth: the edge of the lit side is soft, and warm where it is skin.
    float lit = soft_cosine(n_l, 0.30, 1.0 / 0.30);
    float half_length = inversesqrt(max(2.0 + 2.0 * dot(v, l), 1e-4));
    float roughness = mix(draw.albedo.w, 0.72 - 0.22 * draw.clay.w, albedo.w);
    float gloss = ggx(max((n_v + n_l) * half_length, 0.0), n_v, max(n_l, 0.0), roughness);
    vec3 f0 = mix(vec3(0.04), draw.albedo.rgb, draw.surface.x * (1.0 - albedo.w));
    vec3 light = ambient + frame.key_radiance.rgb * key * (albedo.rgb * lit + f0 * gloss * 3.14159265);
    out_colour = vec4(encode(light), 1.0);
}

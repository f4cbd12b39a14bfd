#version 460
#extension GL_GOOGLE_include_directive : require
// A hand or a tool: soft light on flesh, cloth and wood, a wet gleam where clay lies on it.
#include "surface.glsl"
#include "tone.glsl"

layout(location = 0) in vec3 view;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 albedo;
layout(location = 3) in vec3 ambient;
layout(location = 4) in vec3 key;
layout(location = 5) in vec3 mirror;
layout(location = 6) flat in vec3 light_from;
layout(location = 0) out vec4 out_colour;

void main() {
    vec3 n = normalize(normal);
    vec3 v = view;
    vec3 l = light_from;
    float n_l = dot(n, l);
    float n_v = max(dot(n, v), 0.05);
    // Light scatters under skin and in cloth: the edge of the lit side is soft, and warm where it is skin.
    float lit = soft_cosine(n_l, 0.30, 1.0 / 0.30);
    float half_length = inversesqrt(max(2.0 + 2.0 * dot(v, l), 1e-4));
    float gloss = ggx(max((n_v + n_l) * half_length, 0.0), n_v, max(n_l, 0.0), albedo.w);
    vec3 light = ambient + key.rgb * (albedo.rgb * lit + mirror.rgb * gloss * 3.14159265);
    out_colour = vec4(encode(light), 1.0);
}

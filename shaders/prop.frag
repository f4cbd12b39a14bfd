#version 460
#extension GL_GOOGLE_include_directive : require
// A hand or a tool. The CPU backend lights vertices the same way (prop_light.cpp).
#include "tone.glsl"
#include "hand.h"

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
    float n_l = dot(n, light_from);
    float gleam = hand_gleam(n_l, dot(n, view), dot(view, light_from), albedo.w);
    vec3 light = ambient + key * (albedo.rgb * hand_lit(n_l) + mirror * gleam);
    out_colour = vec4(encode(light), 1.0);
}

#version 460
#extension GL_GOOGLE_include_directive : require
// A hand or a tool. Its triangles are a few pixels large, so that on one software core its vertices are lit
// instead (ONGGI_VERTEX_LIT), and what they look like is only spread between them. Where the processor draws them
// itself it does the same (mover_light.cpp), and tests hold it to this.
#ifdef ONGGI_VERTEX_LIT
layout(location = 0) in vec3 encoded;
#else
#include "surface.glsl"
#include "tone.glsl"
#include "mover.glsl"

layout(location = 0) in vec3 view;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 albedo;
layout(location = 3) in vec3 ambient;
layout(location = 4) in vec3 key;
layout(location = 5) in vec3 mirror;
layout(location = 6) flat in vec3 light_from;
#endif
layout(location = 0) out vec4 out_colour;

void main() {
#ifdef ONGGI_VERTEX_LIT
    out_colour = vec4(encoded, 1.0);
#else
    vec3 light =
        mover_light(normalize(normal), view, light_from, albedo.rgb, albedo.w, ambient, key, mirror);
    out_colour = vec4(encode(light), 1.0);
#endif
}

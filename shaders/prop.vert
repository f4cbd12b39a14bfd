#version 460
#extension GL_GOOGLE_include_directive : require
// A hand or a tool. Slowly varying light is computed per vertex, to keep the fragment shader short.
#include "frame.glsl"
#include "hand.h"
#include "lathe_shadow.glsl"
#include "sky.glsl"

layout(push_constant) uniform DrawBlock {
    PropDraw draw;
};
layout(location = 0) in vec3 position_mm;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 wear;  // tone, smear, unused, open sky
layout(location = 0) out vec3 out_view;  // towards the eye, unit
layout(location = 1) out vec3 out_normal;
layout(location = 2) out vec4 out_albedo;   // w: roughness
layout(location = 3) out vec3 out_ambient;  // diffuse and specular ambient light, finished
layout(location = 4) out vec3 out_key;      // key light that arrives here
layout(location = 5) out vec3 out_mirror;   // its reflectance at normal incidence
layout(location = 6) flat out vec3 out_light_from;

void main() {
    vec4 at = vec4(position_mm, 1.0);
    vec3 p = vec3(dot(draw.row_x, at), dot(draw.row_y, at), dot(draw.row_z, at));
    vec3 n = normalize(
        vec3(dot(draw.row_x.xyz, normal), dot(draw.row_y.xyz, normal), dot(draw.row_z.xyz, normal)));
    vec3 v = normalize(frame.eye.xyz - p);

    float smear = wear.y;
    vec3 albedo = hand_albedo(draw.albedo.rgb, draw.smear.rgb, wear.x, smear);
    float metalness = draw.surface.x * (1.0 - smear);
    float roughness = hand_roughness(draw.albedo.w, draw.smear.w, smear);
    float open = wear.w;
    out_view = v;
    out_normal = n;
    out_albedo = vec4(albedo * (1.0 - metalness), roughness);
    out_ambient = hand_ambient(albedo, metalness, roughness, max(dot(n, v), 0.0), open, sky_diffuse(n),
                               sky_radiance(reflect(-v, n), roughness));
    out_key = frame.key_radiance.rgb * (past_lathe_to_light(p + 2.0 * n) * hand_key_seen(open));
    out_mirror = hand_mirror(draw.albedo.rgb, metalness);
    out_light_from = frame.key_direction.xyz;
    gl_Position = frame.view_projection * vec4(p, 1.0);
}

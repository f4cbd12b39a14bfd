#version 460
#extension GL_GOOGLE_include_directive : require
// A hand or a tool. What changes slowly over it is worked out here; the pixels do little, or nothing at all where
// a vertex is lit whole (ONGGI_VERTEX_LIT).
#include "frame.glsl"
#include "lathe_shadow.glsl"
#include "sky.glsl"
#include "surface.glsl"
#ifdef ONGGI_VERTEX_LIT
#include "tone.glsl"
#include "mover.glsl"
#endif

layout(push_constant) uniform DrawBlock {
    MoverDraw draw;
};
layout(location = 0) in vec3 position_mm;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 wear;  // tone, smear, unused, open sky
#ifdef ONGGI_VERTEX_LIT
layout(location = 0) out vec3 out_encoded;
#else
layout(location = 0) out vec3 out_view;  // towards the eye, unit
layout(location = 1) out vec3 out_normal;
layout(location = 2) out vec4 out_albedo;   // w: roughness
layout(location = 3) out vec3 out_ambient;  // of diffuse and mirrored light together, finished
layout(location = 4) out vec3 out_key;      // key light that gets here
layout(location = 5) out vec3 out_mirror;   // what is mirrored of it, straight on
layout(location = 6) flat out vec3 out_light_from;
#endif

void main() {
    vec4 at = vec4(position_mm, 1.0);
    vec3 p = vec3(dot(draw.row_x, at), dot(draw.row_y, at), dot(draw.row_z, at));
    vec3 n = normalize(
        vec3(dot(draw.row_x.xyz, normal), dot(draw.row_y.xyz, normal), dot(draw.row_z.xyz, normal)));
    vec3 v = normalize(frame.eye.xyz - p);

    float smear = wear.y;
    vec3 own = draw.albedo.rgb * (0.5 + wear.x);
    vec3 albedo = mix(own, draw.clay.rgb, smear);
    float metalness = draw.surface.x * (1.0 - smear);
    float roughness = mix(draw.albedo.w, 0.72 - 0.22 * draw.clay.w, smear);
    vec3 f0 = mix(vec3(0.04), albedo, metalness);
    vec3 mirror = f0 + (max(vec3(1.0 - roughness), f0) - f0) * pow(1.0 - max(dot(n, v), 0.0), 5.0);
    vec3 body = albedo * (1.0 - metalness);
    float open = wear.w;

    vec3 ambient = body * sky_diffuse(n) * open_sky_colour(open, albedo) +
                   mirror * sky_radiance(reflect(-v, n), roughness) * open;
    vec3 key = frame.key_radiance.rgb * (past_lathe_to_light(p + 2.0 * n) * mix(0.55, 1.0, open));
    vec3 straight_on = mix(vec3(0.04), draw.albedo.rgb, metalness);
#ifdef ONGGI_VERTEX_LIT
    out_encoded =
        encode(mover_light(n, v, frame.key_direction.xyz, body, roughness, ambient, key, straight_on));
#else
    out_view = v;
    out_normal = n;
    out_albedo = vec4(body, roughness);
    out_ambient = ambient;
    out_key = key;
    out_mirror = straight_on;
    out_light_from = frame.key_direction.xyz;
#endif
    gl_Position = frame.view_projection * vec4(p, 1.0);
}

#version 460
#extension GL_GOOGLE_include_directive : require
// A pot's vertices, positioned by the processor. This shader computes the slowly varying light per vertex:
// llvmpipe pays for pixels, not for a few thousand vertices.
#include "frame.glsl"
#include "lathe.h"
#include "sky.glsl"
#include "spheres.glsl"

layout(std430, set = 0, binding = kBindRows) readonly buffer RowBlock {
    RowData rows[];
};
layout(std430, set = 0, binding = kBindVertices) readonly buffer VertexBlock {
    VertexData vertices[];
};
layout(push_constant) uniform DrawBlock {
    LatheDraw draw;
};

layout(location = 0) out vec3 out_to_eye;     // mm
// Outward in xy; in z the coordinate of its normal in the texture; in w the key light that arrives here.
layout(location = 1) out vec4 out_outline;
// Streak coordinates in xy; in z the water on the surface; in w the slope caused by dents.
layout(location = 2) out vec4 out_detail;
layout(location = 3) out vec4 out_ambient;    // diffuse, without the albedo; w: gloss roughness of the body
layout(location = 4) out vec4 out_mirrored;   // w: Oren-Nayar roughness of the body
layout(location = 5) out vec4 out_albedo;     // w: factor by which that roughness dims the light
// One over the distance to the eye; one over the length of view plus light.
layout(location = 6) out vec2 out_slow;
layout(location = 7) flat out vec4 out_light_from;  // w: soft edge, as a cosine
layout(location = 8) flat out vec4 out_radiance;    // w: one over the soft edge
// Streaks; roughness of the film; weight of the glaze; reflectance of the film at normal incidence.
layout(location = 9) flat out vec4 out_gloss_of;
layout(location = 10) flat out vec4 out_eye;        // w: tangent of half the light's width
layout(location = 11) flat out vec4 out_spheres[kSpheres];
#ifdef ONGGI_LOAD
layout(location = 15) out vec2 out_load;  // y: along the hatch, mm
#endif

void main() {
    int in_row = int(draw.turn.y);
    int row_number = gl_VertexIndex / in_row;
    RowData row = rows[row_number];
    VertexData vertex = vertices[gl_VertexIndex];
    vec2 outward = vertex.lean.xz;

    vec3 position = vertex.place.xyz;
    vec2 profile = row.light.xy;
    vec3 n =
        normalize(vec3(profile.x * outward.x, profile.y - profile.x * vertex.lean.y, profile.x * outward.y));
    float inside = row.light.w;
    float open = lathe_open(row.light.z, row.place.y, n.y, inside) * sky_past_spheres(position, n);
    vec3 from = normalize(mix(n, vec3(0.0, 1.0, 0.0), lathe_from_mouth(inside, open)));
    vec3 albedo = mix(draw.dry.rgb, draw.wet.rgb, row.water.x);
    out_to_eye = frame.eye.xyz - position;
    float nearness = inversesqrt(dot(out_to_eye, out_to_eye));
    vec3 v = out_to_eye * nearness;
    float l_v = dot(frame.key_direction.xyz, v);
    out_slow = vec2(nearness, half_of(l_v));
    float rough = lathe_rough(row.water.x);
    out_ambient = vec4(sky_diffuse(from) * open_sky_colour(open, albedo),
                       lathe_roughness(draw.gloss.x, draw.gloss.y, row.water.x));
    out_mirrored = vec4(sky_radiance(reflect(-v, n), lathe_sky_roughness(draw.gloss.w)) * open, rough);
    out_albedo = vec4(albedo, lathe_left(rough));
    out_outline = vec4(outward, row.place.z, vertex.place.w);
    vec2 detail_at = vec2(2.0 * vertex.lean.w, row.place.w / kStreakMm);
    out_detail = vec4(detail_at.x + draw.turn.x, detail_at.y, row.water.y, vertex.lean.y);
#ifdef ONGGI_LOAD
    out_load = vec2(row.water.z, detail_at.x * kStreakRoundMm + detail_at.y * kStreakMm);
#endif
    out_light_from = vec4(frame.key_direction.xyz, draw.wet.w);
    out_radiance = vec4(frame.key_radiance.rgb, draw.turn.w);
    out_gloss_of = vec4(draw.dry.w, draw.gloss.zw, draw.turn.z);
    out_eye = vec4(frame.eye.xyz, frame.key_direction.w);
    out_spheres = frame.spheres;
    gl_Position = frame.view_projection * vec4(position, 1.0);
}

#version 460
#extension GL_GOOGLE_include_directive : require
// A pot's vertices, placed on the processor; here the light that changes slowly over them: llvmpipe pays for
// pixels, not for a few thousand vertices.
#include "frame.glsl"
#include "sky.glsl"
#include "surface.glsl"

layout(std430, set = 0, binding = kBindRows) readonly buffer RowBlock {
    RowData rows[];
};
layout(std430, set = 0, binding = kBindVertices) readonly buffer VertexBlock {
    VertexData vertices[];
};
layout(push_constant) uniform DrawBlock {
    LatheDraw draw;
};

layout(location = 0) out vec3 out_to_eye;  // mm
layout(location = 1) out vec4 out_outline;  // xy: the way outwards; z: where its normal lies in the texture;
                                            // w: key light that gets here
layout(location = 2) out vec2 out_detail;   // where its slip lies in the texture
layout(location = 3) out vec3 out_ambient;  // diffuse, without the albedo
layout(location = 4) out vec3 out_mirrored;
layout(location = 5) out vec3 out_water;  // in the body, on it; how dents lean the wall, as a slope
// One over the distance to the eye; one over the length of view and light together; what the body's roughness
// takes of the light.
layout(location = 6) out vec3 out_slow;
#ifdef ONGGI_LOAD
layout(location = 7) out float out_load;
#endif

void main() {
    int in_row = int(draw.turn.y);
    int row_number = gl_VertexIndex / in_row;
    int sector = gl_VertexIndex - row_number * in_row;
    RowData row = rows[row_number];
    VertexData vertex = vertices[gl_VertexIndex];
    vec2 outward = vertex.lean.xz;

    vec3 position = vertex.place.xyz;
    vec2 profile = row.light.xy;
    vec3 n =
        normalize(vec3(profile.x * outward.x, profile.y - profile.x * vertex.lean.y, profile.x * outward.y));
    float open = row.light.z;
    float inside = row.light.w;
    // Close to what it stands on, a wall sees less of the sky.
    open *= 1.0 - 0.55 * exp(-row.place.y * 0.07) * (1.0 - n.y) * (1.0 - inside);
    open *= sky_past_spheres(position, n);
    // Deep inside, what light there is comes down through the mouth, whichever way the wall looks.
    vec3 from = normalize(mix(n, vec3(0.0, 1.0, 0.0), inside * 0.75 * (1.0 - open)));
    vec3 albedo = mix(draw.dry.rgb, draw.wet.rgb, row.water.x);
    out_ambient = sky_diffuse(from) * open_sky_colour(open, albedo);
    out_to_eye = frame.eye.xyz - position;
    float nearness = inversesqrt(dot(out_to_eye, out_to_eye));
    vec3 v = out_to_eye * nearness;
    float l_v = dot(frame.key_direction.xyz, v);
    out_slow = vec3(nearness, inversesqrt(max(2.0 + 2.0 * l_v, 1e-4)),
                    1.0 / (1.0 + 0.288 * (0.85 - 0.5 * row.water.x)));
    float roughness = mix(0.30, 0.20, draw.gloss.w);
    out_mirrored = sky_radiance(reflect(-v, n), roughness) * open;
    out_outline = vec4(outward, row.place.z, vertex.place.w);
    // Two of the texture go round. Up the pot it goes by length along the outline, over the rim and down
    // inside.
    out_detail = vec2(2.0 * float(sector) / float(in_row - 1), row.place.w / 67.0);
    out_water = vec3(row.water.xy, vertex.lean.y);
#ifdef ONGGI_LOAD
    out_load = row.water.z;
#endif
    gl_Position = frame.view_projection * vec4(position, 1.0);
}

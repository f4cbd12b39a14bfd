#version 460
#extension GL_GOOGLE_include_directive : require
// The lathe, see lathe.h, with the outline's normal per pixel and streaks that turn with it. A value of a
// uniform buffer costs thirty multiplications on a software device, so values that vary slowly or not at all
// come from the vertices.
#include "frame_data.h"
#include "lathe.h"
#ifdef ONGGI_LOAD
#include "load.glsl"
#endif
#include "tone.glsl"

layout(set = 0, binding = kBindNormals) uniform usamplerBuffer outline_normals;
layout(set = 0, binding = kBindDetail) uniform sampler2D detail;
layout(constant_id = 0) const bool kNearSpheres = true;  // where a sphere's shadow may fall

layout(location = 0) in vec3 to_eye;
layout(location = 1) in vec4 outline;
layout(location = 2) in vec4 detail_at;
layout(location = 3) in vec4 ambient;
layout(location = 4) in vec4 mirrored;
layout(location = 5) in vec4 body_albedo;
layout(location = 6) in vec2 slow;
layout(location = 7) flat in vec4 light_from;
layout(location = 8) flat in vec4 radiance;
layout(location = 9) flat in vec4 gloss_of;
layout(location = 10) flat in vec4 eye;
layout(location = 11) flat in vec4 spheres[kSpheres];
#ifdef ONGGI_LOAD
layout(location = 15) in vec2 load;
#endif
layout(location = 0) out vec4 out_colour;
#ifdef ONGGI_MARKS
layout(std430, set = 0, binding = kBindMarks) readonly buffer MarkBlock {
    uvec2 marks[];
};
layout(push_constant) uniform DrawBlock {
    LatheDraw draw;
};

struct Mark {
    vec4 colour;  // rgb square roots of light; a coverage
    vec2 lean;
};

// Bilinear, like a sampler; there are no marks beyond the end of the outside.
Mark mark_at(float turns, float height_mm, float along_mm) {
    int columns = int(draw.marks.z);
    int rows = marks.length() / columns;
    vec2 at = vec2(fract(turns) * draw.marks.z, height_mm * draw.marks.x) - 0.5;
    vec2 fraction = fract(at);
    ivec2 first = ivec2(floor(at));
    vec4 colour = vec4(0.0);
    vec2 lean = vec2(0.0);
    float covered = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 step = ivec2(i & 1, i >> 1);
        vec2 share = mix(1.0 - fraction, fraction, vec2(step));
        ivec2 place = ivec2((first.x + step.x + columns) % columns, clamp(first.y + step.y, 0, rows - 1));
        uvec2 mark = marks[place.y * columns + place.x];
        vec4 own = unpackUnorm4x8(mark.x);
        float weight = share.x * share.y;
        colour += vec4(own.rgb * own.a, own.a) * weight;
        lean += unpackUnorm4x8(mark.y).xy * weight;
    }
    colour.rgb /= max(colour.a, 1e-4);
    Mark found = Mark(colour, vec2(lathe_mark_lean(lean.x, draw.marks.w), lathe_mark_lean(lean.y, draw.marks.w)));
    if (along_mm > draw.marks.y) found = Mark(vec4(0.0), vec2(0.0));
    return found;
}
#endif

vec2 from_sixteen_bits(uint word) {
    return vec2(int(word & 0xFFFFu), int(word >> 16)) * (1.0 / 65535.0);
}

void main() {
    vec3 l = light_from.xyz;
    int texel = clamp(int(outline.z * float(kProfileTexels)), 0, kProfileTexels - 1);
    vec2 profile = from_sixteen_bits(texelFetch(outline_normals, texel).r) * 2.0 - 1.0;
    // r: brightness; g, b: slope around the pot and up it; a: thickness of the film.
    vec4 mark = texture(detail, detail_at.xy);
    float streaks = gloss_of.x;
    vec2 lean = vec2(lathe_lean(streaks, mark.g), lathe_lean(streaks, mark.b));
#ifdef ONGGI_MARKS
    // Streaks run clockwise from above, two texture widths per turn.
    Mark painted = mark_at(-0.5 * detail_at.x, eye.y - to_eye.y, detail_at.y * kStreakMm);
    lean += vec2(-painted.lean.x, painted.lean.y);
#endif
    vec2 outward = outline.xy;
    // Dents and streaks tilt the wall. Between two sectors the outward vector is a chord, slightly shorter
    // than 1.
    vec3 n = normalize(vec3(profile.x * outward.x - lean.x * outward.y,
                            profile.y - profile.x * detail_at.w + lean.y,
                            profile.x * outward.y + lean.x * outward.x));

    vec3 v = to_eye * slow.x;
    float n_l = dot(n, l);
    float n_v = max(dot(n, v), 0.05);
    float l_v = dot(l, v);
    vec3 albedo = body_albedo.rgb * lathe_tone(streaks, mark.r);
#ifdef ONGGI_MARKS
    for (int channel = 0; channel < 3; ++channel)
        albedo[channel] = lathe_marked(albedo[channel], painted.colour[channel], painted.colour.a);
#endif
#ifdef ONGGI_LOAD
    albedo = with_load(albedo, load.x, load.y);
#endif
    float seen = outline.w;
    if (kNearSpheres) {
        vec3 position = eye.xyz - to_eye;
        seen *= past_sphere(spheres[0], l, eye.w, position) * past_sphere(spheres[1], l, eye.w, position) *
                past_sphere(spheres[2], l, eye.w, position) * past_sphere(spheres[3], l, eye.w, position);
    }

    float s = fujii_s(l_v, n_l, n_v);
    float t = fujii_t(s, n_l, n_v);
    float n_h = max((n_v + n_l) * slow.y, 0.0);
    float light_l = max(n_l, 0.0);
    float film = lathe_film(detail_at.z, mark.a, gloss_of.z);
    float body_under = ggx_under(n_h, n_v, light_l, ambient.w);
    float sheen_under = ggx_under(n_h, n_v, light_l, gloss_of.y);
    float body_sheen = body_under * sheen_under;
    float fraction = 1.0 / (body_sheen * t);
    float lit = lathe_lit(soft_cosine(n_l, light_from.w, radiance.w), mirrored.w, s, body_sheen, fraction,
                         body_albedo.w);
    float gloss = lathe_gloss(ggx_over(light_l, ambient.w), body_under, ggx_over(light_l, gloss_of.y), sheen_under,
                             gloss_of.w, film, fraction * t);
    vec3 light = albedo * (ambient.rgb + radiance.rgb * (lit * seen)) + radiance.rgb * (gloss * seen) +
                 mirrored.rgb * lathe_mirror(gloss_of.w, n_v, film);
    out_colour = vec4(encode(light), 1.0);
}

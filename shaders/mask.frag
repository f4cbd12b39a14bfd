#version 460
#extension GL_GOOGLE_include_directive : require
// The shadow of moving things on y = 0, projected along the light: r visible fraction of the key light, g of
// the sky. Drawn only when the outline or a tool has changed.
#include "frame.glsl"
#include "shadow.h"
#include "spheres.glsl"

layout(location = 0) in vec2 position;
layout(location = 0) out vec2 out_seen;

float gap_at(int i, vec2 q) {
    return ground_gap(frame.shadow_steps[i], q.x, q.y);
}

float past_lathe(vec2 q) {
    float least = 1e3;
    for (int i = 0; i < kShadowSteps; i += 4) {
        vec4 gaps = vec4(gap_at(i, q), gap_at(i + 1, q), gap_at(i + 2, q), gap_at(i + 3, q));
        vec2 pairs = min(gaps.xy, gaps.zw);
        least = min(least, min(pairs.x, pairs.y));
    }
    return ground_lit(least);
}

void main() {
    vec2 at = frame.mask_origin.xy + position.x * frame.mask_axes.xy + position.y * frame.mask_axes.zw;
    vec3 q = vec3(at.x, 0.0, at.y);
    float seen = past_spheres(q);
    float open = sky_past_spheres(q, vec3(0.0, 1.0, 0.0));
    if (frame.lathe.x > 0.0) {
        seen *= past_lathe(q.xz);
        float from_foot = max(length(q.xz - frame.lathe_foot.xy) - frame.lathe.w, 0.0);
        open *= ground_open(from_foot);
    }
    out_seen = mix(vec2(1.0), vec2(seen, open), inside_mask(position.x, position.y));
}

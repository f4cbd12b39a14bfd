#version 460
#extension GL_GOOGLE_include_directive : require
// The photographed room while the camera is between two backgrounds: the relief of a background, or with ONGGI_SURFACE
// a mesh that stands for a part of the room. Either says where a point is; what it looks like is seen from
// both backgrounds' cameras.
#include "frame.glsl"
#include "transition.glsl"

layout(set = 0, binding = kBindMask) uniform sampler2D shadow_mask;
layout(set = 0, binding = kBindFromDepth) uniform sampler2D from_depth;  // mm
layout(set = 0, binding = kBindToDepth) uniform sampler2D to_depth;

layout(location = 0) in vec3 position_mm;
layout(location = 0) out vec4 out_from;  // the place in the background, times w; w; fraction of the second background
#ifdef ONGGI_SURFACE
layout(push_constant) uniform DrawBlock {
    MeshDraw draw;
};
layout(location = 1) in vec3 normal;
layout(location = 1) out vec3 out_mask;  // place in the shadow mask; how much the foot's shade counts
#else
layout(location = 1) out float out_seen;
#endif
layout(location = 2) out vec3 out_to;

vec3 place_in(mat4 background, vec3 p) {
    vec4 clip = background * vec4(p, 1.0);
    return vec3(0.5 * (clip.xy + clip.w), clip.w);
}

// How well a background shows a point: not at all where something stands before it or the background ends.
float shown_by(sampler2D depth, vec3 place) {
    vec2 at = place.xy / place.z;
    vec2 from_edge = min(at, 1.0 - at);
    float behind = place.z - textureLod(depth, at, 0.0).r;
    return smoothstep(-0.01, 0.03, min(from_edge.x, from_edge.y)) * (1.0 - smoothstep(50.0, 130.0, behind));
}

void main() {
#ifdef ONGGI_SURFACE
    vec3 p = draw.place.xyz + position_mm;
#else
    vec3 p = position_mm;
#endif
    vec2 uv = vec2(dot(frame.mask_u.xyz, p) + frame.mask_u.w, dot(frame.mask_v.xyz, p) + frame.mask_v.w);
    vec3 from = place_in(frame.background_from, p);
    float fraction = frame.transition.x;
    if (kMixes) {
        out_to = place_in(frame.background_to, p);
        float in_from = (1.0 - fraction) * max(shown_by(from_depth, from), 0.001);
        float in_to = fraction * max(shown_by(to_depth, out_to), 0.001);
        fraction = in_to / (in_from + in_to);
    } else {
        out_to = vec3(0.0);
    }
    out_from = vec4(from, fraction);
#ifdef ONGGI_SURFACE
    out_mask = vec3(uv, smoothstep(-7.0, -1.0, p.y) * max(normal.y, 0.0));
#else
    // So far from the foot the shadow is soft: a lookup a corner of the grid will do.
    out_seen = textureLod(shadow_mask, uv, 0.0).r;
    // The relief is coarse; where a mesh stands for the same thing, the mesh is to be seen. Pushed along the
    // line of sight a point changes its depth and not its place in the picture; the wheel's goes behind all
    // of the wheel.
    bool is_wheel = length(p.xz) < 240.0 && p.y > -90.0 && p.y < 20.0;
    p += normalize(p - frame.eye.xyz) * (is_wheel ? 500.0 : 60.0);
#endif
    gl_Position = frame.view_projection * vec4(p, 1.0);
}

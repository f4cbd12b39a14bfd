#version 460
#extension GL_GOOGLE_include_directive : require
// The lathe from its radii alone. A vertex is a row and a sector; rows are the chosen rings, then the rounded
// top edge, then the axis. What changes slowly over the surface is worked out here: llvmpipe pays for pixels,
// not for a few thousand vertices.
#include "frame.glsl"
#include "sky.glsl"
#include "surface.glsl"

layout(std430, set = 0, binding = kBindRadii) readonly buffer RadiiBlock { float radii[]; };
layout(std430, set = 0, binding = kBindRings) readonly buffer RingBlock { RingData rings[]; };
layout(push_constant) uniform DrawBlock { LatheDraw draw; };

layout(location = 0) out vec3 out_position;
layout(location = 1) out vec4 out_outline;  // xy: the way outwards; z: where its normal lies in the texture; w: key light that gets here
layout(location = 2) out vec2 out_detail;   // where its slip lies in the texture
layout(location = 3) out vec3 out_ambient;  // diffuse, without the albedo
layout(location = 4) out vec3 out_mirrored;

const float kPi = 3.14159265;

// How much of the key light passes the rest of the wall: the least angle between the ray to the light and the
// outline, in halves of the light's width.
float past_wall(vec3 p) {
    vec3 l = frame.key_direction.xyz;
    float height = frame.lathe.x;
    float reach = max(height - p.y, 0.1) / max(l.y, 0.05);
    float least = 1e3;
    const int kSteps = 14;
    for (int i = 1; i <= kSteps; ++i) {
        float t = reach * (float(i) / float(kSteps));
        vec3 at = p + l * t;
        float element = clamp(at.y * frame.lathe.y, 0.0, frame.lathe.z - 1.0);
        float gap = length(at.xz) - radii[int(element)];
        least = min(least, gap / t);
    }
    float width = frame.key_direction.w;
    // Along a convex wall the gap opens as slowly as the light grazes it; that shade is the cosine's, so only
    // what is truly inside the wall counts as hidden.
    return smoothstep(-2.0 * width, 0.25 * width, least);
}

void main() {
    int in_row = int(draw.edge.w);
    int row = gl_VertexIndex / in_row;
    int sector = gl_VertexIndex - row * in_row;
    int ring_count = int(draw.edge.z);
    float sectors = draw.edge.y;
    float turned = float(sector) / sectors;
    float angle = turned * 2.0 * kPi;
    vec2 outward = vec2(cos(angle), sin(angle));
    // A polygon inside the circle looks thinner than it; half of the sag outside, half inside, looks right.
    float straddle = 1.0 + 0.5 * (1.0 - cos(kPi / sectors));

    float r;
    float y;
    float open = 1.0;
    float u;
    vec2 normal;
    float rounding = draw.edge.x;
    if (row < ring_count) {
        RingData ring = rings[row];
        r = radii[ring.element];
        y = ring.y_mm;
        open = ring.open_sky;
        u = ring.profile_u;
        float element_height = 1.0 / frame.lathe.y;
        uint above = min(ring.element + 8u, uint(frame.lathe.z) - 1u);
        uint below = uint(max(int(ring.element) - 8, 0));
        normal = normalize(vec2(float(above - below) * element_height, radii[below] - radii[above]));
    } else if (row < ring_count + kEdgeRows) {
        float share = float(row - ring_count) / float(kEdgeRows - 1);
        float lean = share * 0.5 * kPi;
        normal = vec2(cos(lean), sin(lean));
        r = draw.turn.z - rounding * (1.0 - normal.x);
        y = draw.turn.w + rounding * normal.y;
        u = (float(kProfileWallTexels) + 0.5 + share * float(kProfileEdgeTexels - 1)) / float(kProfileTexels);
    } else {
        normal = vec2(0.0, 1.0);
        r = 0.0;
        y = draw.turn.w + rounding;
        u = (float(kProfileTexels) - 0.5) / float(kProfileTexels);
    }
    r *= straddle;

    out_position = vec3(r * outward.x, y, r * outward.y);
    vec3 n = vec3(normal.x * outward.x, normal.y, normal.x * outward.y);
    // Close to what it stands on, a wall sees less of the sky.
    open *= 1.0 - 0.5 * exp(-y * 0.06) * (1.0 - normal.y);
    open *= sky_past_spheres(out_position, n);
    out_ambient = sky_diffuse(n) * open_sky_colour(open, draw.albedo.rgb);
    vec3 v = normalize(frame.eye.xyz - out_position);
    out_mirrored = sky_radiance(reflect(-v, n), 0.28) * open;
    // Over the rounded edge the radii are those of the edge before it was rounded; nothing stands above it.
    bool may_hide = row < ring_count && dot(n, frame.key_direction.xyz) > -0.25;
    float key_seen = may_hide ? past_wall(out_position + n * 0.5) : 1.0;
    out_outline = vec4(outward, u, key_seen);
    // Two of the texture go round; over the top it runs on towards the axis.
    out_detail = vec2(2.0 * turned, (row < ring_count + kEdgeRows ? y : y + draw.turn.z) / 67.0);
    gl_Position = frame.view_projection * vec4(out_position, 1.0);
}

#version 460
#extension GL_GOOGLE_include_directive : require
// Static meshes. With ONGGI_LAYERS they are drawn once, into the layers that the frames are composed of;
// without, into the finished picture (stills, GPUs, tools).
#include "frame.glsl"
#include "noise.glsl"
#include "packed.glsl"
#include "sky.glsl"
#include "surface.h"
#include "tone.glsl"

#ifndef ONGGI_LAYERS
layout(set = 0, binding = kBindMask) uniform sampler2D shadow_mask;
#endif
layout(set = 0, binding = kBindShadowMap) uniform sampler2DShadow shadow_map;
layout(push_constant) uniform DrawBlock {
    MeshDraw draw;
};

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in float open_sky;
layout(location = 0) out vec4 out_colour;  // finished; with ONGGI_LAYERS: with the key light
#ifdef ONGGI_LAYERS
layout(location = 1) out vec4 out_ambient;  // without the key light; alpha: weight of the foot's shade
layout(location = 2) out vec4 out_coords;   // coordinates in the shadow mask
#endif

// The still life's own shadow, averaged over a square of seven texels. The weights are computed here, because
// not every device filters depth (lavapipe does not).
float past_still_life() {
    vec4 at = frame.key_view_projection * vec4(position, 1.0);
    vec2 texel = (at.xy * 0.5 + 0.5) * kShadowMapTexels - 0.5;
    vec2 base = floor(texel);
    vec2 fraction = texel - base;
    float depth = min(at.z, 1.0);  // ground beyond the map's far plane is not in shade
    float seen = 0.0;
    for (int y = -3; y <= 4; ++y) {
        float weight_y = y == -3 ? 1.0 - fraction.y : (y == 4 ? fraction.y : 1.0);
        for (int x = -3; x <= 4; ++x) {
            float weight_x = x == -3 ? 1.0 - fraction.x : (x == 4 ? fraction.x : 1.0);
            seen += weight_x * weight_y *
                    texture(shadow_map, vec3((base + vec2(x, y) + 0.5) / kShadowMapTexels, depth));
        }
    }
    return seen / 49.0;
}

void main() {
    // Materials are within these bounds already; without the clamp, Mesa's compiler for the Raspberry Pi 5
    // crashes.
    float roughness = clamp(draw.albedo.w, 0.05, 1.0);
    float metalness = draw.surface.x;
    vec3 n = normalize(in_normal);
    vec3 v = normalize(frame.eye.xyz - position);
    vec3 l = frame.key_direction.xyz;

    // Uneven colour: two sizes of blotch.
    vec3 albedo = max(draw.albedo.rgb, vec3(0.0));
    if (draw.surface.w > 0.0) {
        vec3 at = position / vec3(draw.pattern.x, 1.0, 1.0);
        float blotch =
            value_noise(at * 0.021) * 0.45 + value_noise(at * 0.11) * 0.35 + value_noise(at * 0.43) * 0.2;
        albedo *= 1.0 + draw.surface.w * (blotch - 0.5) * 2.0;
        roughness = clamp(roughness + draw.surface.w * (blotch - 0.5) * 0.5, 0.05, 1.0);
    }

    // Rings left by a lathe tool tilt the normal in and out along the radius. They fade where a pixel spans
    // more than a third of a ring.
    vec3 radial = vec3(position.x, 0.0, position.z);
    float r = max(length(radial), 1e-3);
    radial /= r;
    float lean = 0.0;
    if (draw.surface.y > 0.0) {
        float turns = r / draw.surface.y;
        float footprint = length(vec2(dFdx(turns), dFdy(turns)));
        float seen = clamp(1.5 - 3.0 * footprint, 0.0, 1.0);
        float uneven = 0.6 + 0.8 * value_noise(vec3(turns * 0.37, 3.0, 7.0));
        lean = draw.surface.z * uneven *
               sin(2.0 * kPi * turns + 4.0 * value_noise(vec3(turns * 0.21, 1.0, 2.0))) * seen;
    }
    vec3 leaning = normalize(n + radial * lean);

    float n_v = max(dot(leaning, v), 1e-3);
    float n_l = dot(leaning, l);
    vec3 h = normalize(v + l);
    vec3 f0 = mix(vec3(0.04), albedo, metalness);
    vec3 body = albedo * (1.0 - metalness);

    float seen = past_still_life();
    float lit = soft_cosine(n_l, 0.14, 1.0 / 0.14) * seen;
    // Rings spread reflections along the radius: a fan of tilted normals approximates that.
    bool is_turned = draw.surface.y > 0.0 && metalness > 0.0;
    float gloss = 0.0;
    vec3 reflected = vec3(0.0);
    for (int i = -3; i <= 3; ++i) {
        if (!is_turned && i != 0) continue;
        vec3 fan = is_turned ? normalize(leaning + radial * (float(i) * 0.075)) : leaning;
        float fraction = is_turned ? 1.0 / 7.0 : 1.0;
        float fan_l = dot(fan, l);
        if (fan_l > 0.0) {
            gloss += fraction * ggx(max(dot(fan, h), 0.0), max(dot(fan, v), 1e-3), fan_l, roughness);
        }
        reflected += fraction * sky_radiance(reflect(-v, fan), roughness);
    }
    gloss *= seen;
    vec3 key_light = frame.key_radiance.rgb * (body * lit + f0 * gloss * kPi);
    vec3 mirror = f0 + (max(vec3(1.0 - roughness), f0) - f0) * grazing(n_v);
    vec3 shade = open_sky_colour(open_sky, albedo);
    vec3 ambient = body * sky_diffuse(leaning) * shade + mirror * reflected * open_sky;

    vec2 uv = vec2(dot(frame.mask_u.xyz, position) + frame.mask_u.w,
                   dot(frame.mask_v.xyz, position) + frame.mask_v.w);
    float near_foot = smoothstep(-7.0, -1.0, position.y) * max(n.y, 0.0);
#ifdef ONGGI_LAYERS
    out_colour = vec4(encode(ambient + key_light) + dither(), 1.0);
    out_ambient = vec4(encode(ambient) + dither(), near_foot);
    out_coords = packed16(uv);
#else
    vec2 mask = texture(shadow_mask, uv).rg;
    vec3 light = (ambient + key_light * mask.r) * mix(1.0, mask.g, near_foot);
    out_colour = vec4(encode(light) + dither(), 1.0);
#endif
}

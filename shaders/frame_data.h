// What C++ and GLSL both know: the layout of everything a shader reads, and the numbers they must agree on.
// Lengths mm, angles rad, linear light. Every member is a vec4 or a mat4, so that std140 and C++ agree.
#ifndef ONGGI_SHADERS_FRAME_DATA_H
#define ONGGI_SHADERS_FRAME_DATA_H

#ifdef __cplusplus
#pragma once
#include <cstdint>

#include "engine/math/math.h"
#define ONGGI_UINT std::uint32_t
#define ONGGI_CONST constexpr
namespace onggi::shaders {
#else
#define ONGGI_UINT uint
#define ONGGI_CONST const
#endif

// The texture of the outline's normals: wall, rounded edge, flat top.
ONGGI_CONST int kProfileTexels = 1024;
ONGGI_CONST int kProfileWallTexels = 976;
ONGGI_CONST int kProfileEdgeTexels = 32;
ONGGI_CONST int kEdgeRows = 5;        // rows of vertices round the top edge
ONGGI_CONST int kPanels = 3;          // soft lights of the sky
ONGGI_CONST int kSpheres = 2;         // that cast a shadow
ONGGI_CONST int kMaskTexels = 96;     // the shadow mask, each way
ONGGI_CONST int kKeyMapTexels = 512;  // the still life's shadow map, each way

// Bindings of the one descriptor set.
ONGGI_CONST int kBindFrame = 0;
ONGGI_CONST int kBindRadii = 1;
ONGGI_CONST int kBindRings = 2;
ONGGI_CONST int kBindNormals = 3;
ONGGI_CONST int kBindDetail = 4;
ONGGI_CONST int kBindMask = 5;
ONGGI_CONST int kBindKeyMap = 6;
ONGGI_CONST int kBindStillKey = 7;
ONGGI_CONST int kBindStillAmbient = 8;
ONGGI_CONST int kBindStillCoords = 9;

struct FrameData {
    mat4 view_projection;
    mat4 key_view_projection;  // of the still life's shadow map
    vec4 eye;                  // xyz mm
    vec4 key_direction;        // xyz towards the light; w tangent of its angular radius
    vec4 key_radiance;         // rgb
    vec4 sky_zenith;
    vec4 sky_horizon;
    vec4 sky_nadir;
    vec4 panel_direction[kPanels];  // xyz; w sharpness
    vec4 panel_radiance[kPanels];
    vec4 irradiance[9];
    vec4 mask_u;  // dot(xyz, p) + w is where p, slid along the light onto y = 0, lies in the mask
    vec4 mask_v;
    vec4 mask_origin;  // the way back: xz of u = v = 0
    vec4 mask_axes;    // xz of u, then xz of v
    vec4 lathe;        // height mm, elements a mm, elements, radius of the foot mm; all 0 without a lathe
    vec4 spheres[kSpheres];  // xyz mm; w radius mm, 0: none
    vec4 backdrop_low;
    vec4 backdrop_high;
    vec4 backdrop_glow;   // rgb; w radius
    vec4 backdrop_shape;  // centre of the glow; half width and half height of the picture, the shorter is 1
    vec4 picture;         // width and height in pixels, and one over them
};

// A ring of vertices.
struct RingData {
    ONGGI_UINT element;
    float y_mm;
    float radius_mm;  // the element's; the shader reads the radii themselves
    float open_sky;   // 0 to 1
    float profile_u;  // where its normal lies in the texture
};

// Push constants of a mesh.
struct MeshDraw {
    vec4 place;    // xyz mm; w scale
    vec4 albedo;   // rgb; w roughness
    vec4 surface;  // metalness, groove pitch mm, groove tilt, grain
    vec4 pattern;  // x how much longer along x the grain is than across
};

// Push constants of the shade: a convex polygon in clip space, two corners a vec4, the last corner repeated.
ONGGI_CONST int kShadeCorners = 16;
struct ShadeDraw {
    vec4 corners[kShadeCorners / 2];
};

// Push constants of the lathe.
struct LatheDraw {
    vec4 albedo;  // rgb, already darkened by water; w streaks
    vec4 water;   // x wetness of the film, y roughness of the body
    vec4 turn;    // x how far the slip has turned, in widths of its texture; zw radius mm and height mm where
                  // the rounding begins
    vec4 edge;    // rounding mm; sectors; rings; vertices in a row
};

#ifdef __cplusplus
}  // namespace onggi::shaders
#endif
#undef ONGGI_UINT
#undef ONGGI_CONST

#endif

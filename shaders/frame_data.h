// Shared by C++ and GLSL: the layout of everything that a shader reads, and the constants that both use.
// Lengths mm, angles rad, linear light. Every member is a vec4 or a mat4, so that std140 and C++ layouts
// agree.
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

ONGGI_CONST int kProfileTexels =
    4096;  // texels of the outline's normals, by arc length: finer than a pixel in the picture
ONGGI_CONST int kOutlineSamples = 512;  // samples of the outline at even heights, for ray marching
ONGGI_CONST int kPanels = 3;            // soft lights of the sky
ONGGI_CONST int kSpheres = 4;           // shadow-casting spheres
// Steps of a ray past the lathe to the ground, over the lathe's height.
ONGGI_CONST int kShadowSteps = 32;
ONGGI_CONST int kMaskTexels = 96;        // size of the shadow mask in each direction
ONGGI_CONST int kShadowMapTexels = 512;  // size of the still life's shadow map in each direction

// Bindings of the one descriptor set; kBindingsOfLayers: the number that the kept layers need.
ONGGI_CONST int kBindFrame = 0;
ONGGI_CONST int kBindShadowMap = 1;
ONGGI_CONST int kBindOutline = 2;
ONGGI_CONST int kBindRows = 3;
ONGGI_CONST int kBindNormals = 4;
ONGGI_CONST int kBindDetail = 5;
ONGGI_CONST int kBindMask = 6;
ONGGI_CONST int kBindBackgroundKey = 7;
ONGGI_CONST int kBindBackgroundAmbient = 8;
ONGGI_CONST int kBindViewBefore = 9;
ONGGI_CONST int kBindVertices = 10;
ONGGI_CONST int kBindMarks = 11;
ONGGI_CONST int kBindings = 12;
ONGGI_CONST int kBindingsOfLayers = 2;

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
    vec4 mask_u;  // dot(xyz, p) + w: mask coordinate of p projected along the light onto y = 0
    vec4 mask_v;
    vec4 mask_origin;  // inverse mapping: xz of u = v = 0
    vec4 mask_axes;    // xz of u, then xz of v
    // Height mm; outline samples per mm; number of samples; foot radius mm; all 0 without a lathe.
    vec4 lathe;
    vec4 lathe_foot;         // xz mm of the foot's centre
    vec4 spheres[kSpheres];  // xyz mm; w radius mm; unused ones are far below everything
    // Steps up the light for the lathe's shadow on the ground: xz mm from the foot to a ray that starts at x
    // = z = 0, the outline's radius at that height, and one over the penumbra's width.
    vec4 shadow_steps[kShadowSteps];
    vec4 backdrop_low;
    vec4 backdrop_high;
    vec4 backdrop_glow;   // rgb; w radius
    vec4 backdrop_shape;  // centre of the glow; half width and half height of the picture, the shorter is 1
    vec4 picture;         // width and height in pixels, and their inverses
    vec4 background_window;  // pixel * xy + zw: place in the background
    vec4 levels;             // levels of the light: rgb all except the key, w the key
    vec4 fade;               // x weight of the previous view, 0 to 1
};

// A row of vertices: values that are constant around it.
struct RowData {
    vec4 place;  // radius mm; y mm; coordinate of its normal in the texture; arc length of the outline mm
    vec4 light;  // normal (r, y); visible fraction of the sky, 0 to 1; 1 inside, 0 outside
    vec4 water;  // water in the body and on the surface, 0 to 1; load; unused
};

// A vertex: its row's values modified by the rotation, dents and the light's direction.
struct VertexData {
    vec4 place;  // xyz mm; w key light that arrives here
    // Xz horizontal outward direction, unit; y slope of the wall caused by dents; w fraction of a turn.
    vec4 lean;
};

// Push constants of a mesh.
struct MeshDraw {
    vec4 place;    // xyz mm
    vec4 albedo;   // rgb; w roughness
    vec4 surface;  // metalness, groove pitch mm, groove tilt, grain
    vec4 pattern;  // x how much longer the grain is along x than across
};

// Push constants of a hand or a tool.
struct PropDraw {
    vec4 row_x;  // rows of the 3 x 4 transform, see Prop
    vec4 row_y;
    vec4 row_z;
    vec4 albedo;   // rgb; w roughness
    vec4 smear;    // rgb of the smear; w its wetness
    vec4 surface;  // metalness; unused
};

// Push constants of the lathe.
struct LatheDraw {
    vec4 dry;    // albedo; w streaks
    vec4 wet;    // albedo of the saturated body; w soft edge
    vec4 gloss;  // roughness of the dry body; of the wet body; of the film or glaze; weight of the glaze
    // X rotation of the streaks, in texture widths; y vertices in a row; z reflectance of the film at normal
    // incidence; w one over the soft edge.
    vec4 turn;
    // X rows of marks per mm; y end of the outside, mm along the outline; z columns; w largest slope.
    vec4 marks;
};

#ifdef __cplusplus
}  // namespace onggi::shaders
#endif
#undef ONGGI_UINT
#undef ONGGI_CONST

#endif

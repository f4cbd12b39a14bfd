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

ONGGI_CONST int kProfileTexels =
    4096;  // of the texture of the outline's normals, by length along it: finer than a pixel
ONGGI_CONST int kOutlineSamples = 512;   // of the outline, evenly by height: what rays are walked against
ONGGI_CONST int kPanels = 3;             // soft lights of the sky
ONGGI_CONST int kSpheres = 4;            // that cast a shadow
ONGGI_CONST int kShadowSteps = 32;       // of a ray past the lathe to the ground, up its height
ONGGI_CONST int kMaskTexels = 96;        // the shadow mask, each way
ONGGI_CONST int kShadowMapTexels = 512;  // the still life's shadow map, each way

// Bindings of the one descriptor set, and how many the layers of a room that is kept need of them.
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
    vec4 mask_u;  // dot(xyz, p) + w is where p, slid along the light onto y = 0, lies in the mask
    vec4 mask_v;
    vec4 mask_origin;  // the way back: xz of u = v = 0
    vec4 mask_axes;    // xz of u, then xz of v
    vec4 lathe;       // height mm, samples of the outline a mm, samples, radius of the foot mm; all 0 without
    vec4 lathe_foot;  // xz mm where the foot stands
    vec4 spheres[kSpheres];  // xyz mm; w radius mm; those that are not there lie far below everything
    // What the lathe's shadow on the ground is found by, step by step up the light: xz mm from the foot to
    // where a ray from x = z = 0 is then, the outline's radius there, and one over the penumbra's width.
    vec4 shadow_steps[kShadowSteps];
    vec4 backdrop_low;
    vec4 backdrop_high;
    vec4 backdrop_glow;   // rgb; w radius
    vec4 backdrop_shape;  // centre of the glow; half width and half height of the picture, the shorter is 1
    vec4 picture;         // width and height in pixels, and one over them
    vec4 background_window;  // pixel * xy + zw is the place in the background
    vec4 levels;             // of the backgrounds' light: rgb all but the key, w the key
    vec4 fade;               // x what is left of the view before, 0 to 1
};

// A row of vertices: all that is the same the whole way round.
struct RowData {
    vec4 place;  // radius mm; y mm; where its normal lies in the texture; along the outline mm
    vec4 light;  // normal (r, y); the sky it sees, 0 to 1; 1 inside, 0 outside
    vec4 water;  // in the body and on it, 0 to 1; load; unused
};

// A vertex: what the turn, dents and the light's direction make of its row here.
struct VertexData {
    vec4 place;  // xyz mm; w the key light that gets here
    vec4 lean;  // xz the horizontal way outwards, unit; y how dents lean the wall, as a slope; w the fraction
                // of a turn
};

// Push constants of a mesh.
struct MeshDraw {
    vec4 place;    // xyz mm
    vec4 albedo;   // rgb; w roughness
    vec4 surface;  // metalness, groove pitch mm, groove tilt, grain
    vec4 pattern;  // x how much longer along x the grain is than across
};

// Push constants of a hand or a tool.
struct PropDraw {
    vec4 row_x;  // of the 3 x 4 matrix that places it, see Prop
    vec4 row_y;
    vec4 row_z;
    vec4 albedo;   // rgb; w roughness
    vec4 smear;    // rgb of what lies on it; w how wet that is
    vec4 surface;  // metalness; unused
};

// Push constants of the lathe.
struct LatheDraw {
    vec4 dry;    // albedo; w streaks
    vec4 wet;    // albedo of the body full of water; w soft edge
    vec4 gloss;  // roughness of the dry body; of the wet one; of the film or the glaze; weight of the glaze
    vec4 turn;   // x how far the streaks have turned, in widths of their texture; y vertices in a row;
                 // z mirror of the film, straight on; w one over the soft edge
    vec4 marks;  // x rows of marks a mm; y where its outside ends, mm along the outline; z columns; w their
                 // most lean
};

#ifdef __cplusplus
}  // namespace onggi::shaders
#endif
#undef ONGGI_UINT
#undef ONGGI_CONST

#endif

// The lathe for the CPU backend: its vertices projected and lit with the light that varies slowly (what
// shaders/lathe.vert does), and its triangles rasterised, eight pixels at a time, with the formulas of
// shaders/lathe.h. lavapipe shades every 4 x 4 block that a triangle touches, three times as many pixels as
// are visible. Any thread; one user of a canvas at a time. Pixels, mm.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/byte_order.h"
#include "engine/render/pixels/picture_shapes.h"
#include "engine/render/scene.h"
#include "engine/render/shapes/lathe_mesh.h"
#include "shaders/frame_data.h"

namespace onggi::render {

// Values that are interpolated linearly between vertices. A vector or colour takes one index per component.
namespace lathe_value {
constexpr std::size_t kToEye = 0;    // unit
constexpr std::size_t kOutward = 3;  // x and z, unit
// Texels of the streaks across and up, not negative; multiplied by kNear.
constexpr std::size_t kStreak = 5;
constexpr std::size_t kNormal = 7;     // texels of the outline's normals
constexpr std::size_t kSeen = 8;       // key light that arrives here
constexpr std::size_t kWater = 9;      // water in the body
constexpr std::size_t kFilm = 10;      // water on the surface
constexpr std::size_t kLean = 11;      // slope of the wall caused by dents
constexpr std::size_t kHalf = 12;      // one over the length of the sum of view and light direction
constexpr std::size_t kLoad = kHalf;   // replaces kHalf where the load is shown: 1 collapses
constexpr std::size_t kAmbient = 13;   // diffuse, of the body's own colour
constexpr std::size_t kMirrored = 16;  // of the sky
constexpr std::size_t kNear = 19;      // one over the distance along the view
constexpr std::size_t kPlain = 20;     // number of values needed where no moving sphere is near
constexpr std::size_t kPlace = 20;     // mm
constexpr std::size_t kDepth = 23;     // as the device's depth buffer stores it
constexpr std::size_t kCount = 24;
}  // namespace lathe_value

// The streaks' texture repeats; this many widths are added to keep its coordinates positive.
constexpr float kStreakWidthsMore = 4.0F;

using LatheCorner = PictureCorner<lathe_value::kCount>;

// Size of the streaks' texture: texels, powers of two.
struct StreakSize {
    int across = 512;
    int up = 512;
};

struct LatheGrid {
    const shaders::FrameData& frame;
    const shaders::LatheDraw& draw;
    std::span<const shaders::RowData> rows;
    std::span<const shaders::VertexData> vertices;  // draw.turn.y in each row
    StreakSize streaks;
    bool shows_load = false;
};
// Computes one corner per vertex; only those that the triangles use are valid. The result is bit-identical
// with and without wide vectors. Reuses the memory of `corners`.
void light_corners(const LatheGrid& grid, std::span<const std::uint16_t> indices,
                   std::vector<LatheCorner>& corners);

// Parameters that are the same for all triangles. `streaks`: four-byte texels made by streak_levels().
struct LatheLook {
    const shaders::FrameData& frame;
    const shaders::LatheDraw& draw;
    const NormalTexels& normals;
    std::span<const std::uint32_t> streaks;
    StreakSize streak_size;
    ByteOrder order = ByteOrder::kRedFirst;
    bool shows_load = false;             // the corners must then have been lit with it
    std::span<const LatheMark> marks{};  // of the scene, see LatheMarks; empty: no marks
};

// Draws triangles, three indices of corners each, that face the eye, with a depth test (nearer or equal
// passes). Triangles with a corner behind the eye are skipped. No sphere's shadow falls on the first `plain`
// indices. The result is bit-identical with and without wide vectors. A canvas of fewer than eight pixels is
// left unchanged.
void draw_lathe(std::span<const LatheCorner> corners, std::span<const std::uint16_t> indices,
                std::size_t plain, const LatheLook& look, const PictureCanvas& canvas);

}  // namespace onggi::render

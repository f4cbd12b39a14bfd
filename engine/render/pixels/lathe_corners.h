// The corners of the lathe, placed in the picture, with the light that changes slowly over it: what
// shaders/lathe.vert does, for a device that is the processor. Any thread; pure. mm, pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/pixels/picture_shapes.h"
#include "shaders/frame_data.h"

namespace onggi::render {

// What grows evenly from corner to corner. Vectors and colours take three, or as many as they have axes.
namespace lathe_value {
constexpr std::size_t kToEye = 0;      // unit
constexpr std::size_t kOutward = 3;    // x and z, unit
constexpr std::size_t kStreak = 5;     // texels of the streaks across and up, not below 0; times kNear
constexpr std::size_t kNormal = 7;     // texels of the outline's normals
constexpr std::size_t kSeen = 8;       // key light that gets here
constexpr std::size_t kWater = 9;      // in the body
constexpr std::size_t kFilm = 10;      // of water on it
constexpr std::size_t kLean = 11;      // how dents lean the wall, as a slope
constexpr std::size_t kHalf = 12;      // one over the length of view and light together
constexpr std::size_t kLoad = kHalf;   // in its place, where load is shown: 1 gives way
constexpr std::size_t kAmbient = 13;   // diffuse, of the body's own colour
constexpr std::size_t kMirrored = 16;  // of the sky
constexpr std::size_t kNear = 19;      // one over the distance along the view
constexpr std::size_t kPlain = 20;     // how many the light needs that no moving sphere is near
constexpr std::size_t kPlace = 20;     // mm
constexpr std::size_t kDepth = 23;     // as the device has it
constexpr std::size_t kCount = 24;
}  // namespace lathe_value

// The streaks' texture repeats; some of its widths are added so that no place in it is below 0.
constexpr float kStreakWidthsMore = 4.0F;

using LatheCorner = PictureCorner<lathe_value::kCount>;

// What of the streaks' texture is read: texels, powers of two.
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
// A corner for each vertex, of which those are good that these triangles need. A processor without wider
// vectors finds the same bits. `corners` is used again.
void light_corners(const LatheGrid& grid, std::span<const std::uint16_t> indices,
                   std::vector<LatheCorner>& corners);

}  // namespace onggi::render

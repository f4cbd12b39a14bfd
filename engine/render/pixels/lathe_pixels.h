// The lathe's pixels by the processor, where that is the device: as shaders/lathe.h says, eight at a
// time. lavapipe shades a triangle by the 4 x 4 blocks it touches, three times as many pixels as are seen.
// Any thread; one user of a canvas at a time. Pixels, mm.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/render/byte_order.h"
#include "engine/render/pixels/lathe_corners.h"
#include "engine/render/scene.h"
#include "engine/render/shapes/lathe_profile.h"

namespace onggi::render {

// What all of it has in common. `streaks` are texels of four bytes, as streak_levels() makes them.
struct LatheLook {
    const shaders::FrameData& frame;
    const shaders::LatheDraw& draw;
    const NormalTexels& normals;
    std::span<const std::uint32_t> streaks;
    StreakSize streak_size;
    ByteOrder order = ByteOrder::kRedFirst;
    bool shows_load = false;             // which the corners must have then
    std::span<const LatheMark> marks{};  // of the scene, see LatheMarks; empty: none
};

// Draws triangles, three indices of corners each, where they look at the eye and nothing that is there is
// nearer; those with a corner behind the eye are left out. On the first `plain` indices no sphere's shadow
// falls. A processor without wider vectors draws the same bits. A canvas of fewer than eight pixels stays as
// it is: nobody sees what is in it.
void draw_lathe(std::span<const LatheCorner> corners, std::span<const std::uint16_t> indices,
                std::size_t plain, const LatheLook& look, const PictureCanvas& canvas);

}  // namespace onggi::render

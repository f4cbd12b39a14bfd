// Rasterises the lathe for the CPU backend, eight pixels at a time, with the formulas of shaders/lathe.h.
// lavapipe shades every 4 x 4 block that a triangle touches, three times as many pixels as are visible. Any
// thread; one user of a canvas at a time. Pixels, mm.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/render/byte_order.h"
#include "engine/render/pixels/lathe_corners.h"
#include "engine/render/scene.h"
#include "engine/render/shapes/lathe_mesh.h"

namespace onggi::render {

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

// Triangles of a bent photograph, by the processor: what shaders/glide.frag does, for a device that is the
// processor itself and pays twelve nanoseconds for every texel. Any thread; one user of a picture at a time.
// Pixels, texels, mm.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/math/math.h"
#include "engine/render/pixels/host_photograph.h"
#include "engine/render/pixels/picture_shapes.h"
#include "engine/render/pixels/shadow_mask.h"

namespace onggi::render {

// Of a corner of the plate's relief, what grows evenly between it and the next: all faces are so small.
enum ReliefValue { kFromU, kFromV, kToU, kToV, kToShare, kSeen, kReliefValues };
// Of a mesh's, the place in the shadow mask instead of what is seen there.
enum SurfaceValue { kMaskU = kSeen, kMaskV, kNearFoot, kSurfaceValues };

using ReliefCorner = PictureCorner<kReliefValues>;
using SurfaceCorner = PictureCorner<kSurfaceValues>;

// What is drawn from and into.
struct BentPicture {
    int width = 0;
    int height = 0;
    std::span<std::uint32_t> pixels;
    std::span<float> depth;  // of surfaces; the caller clears it to 1
    const HostPlate* from = nullptr;
    const HostPlate* to = nullptr;
    const ShadowMask* mask = nullptr;
    // Of each channel in the picture's byte order, what is left of a value where it is not full day; null: it
    // is.
    const std::array<std::array<std::uint8_t, 256>, 3>* dimmed = nullptr;
    ByteOrder order = ByteOrder::kRedFirst;

    [[nodiscard]] PictureSize size() const { return {width, height}; }
};

using Corners = std::array<std::uint32_t, 3>;

// A cell of a relief: its corners, once round.
using Quad = std::array<std::uint32_t, 4>;

// Draws them one over another, whichever way they look; those with a corner behind the eye are left out. A
// processor without wider vectors draws the same bits.
void bend_relief(std::span<const ReliefCorner> corners, std::span<const Quad> quads,
                 const BentPicture& picture);
// Draws those that look at the eye where nothing that was drawn here before is nearer, and its depth.
void bend_surface(std::span<const SurfaceCorner> corners, std::span<const Corners> triangles,
                  const BentPicture& picture);

}  // namespace onggi::render

// What moves, by the processor where that is the device: hands, tools and clay, and their outlines smoothed,
// drawn into a picture that the processor makes. What it cannot draw (a cut, load, bare spheres) the device
// draws over that, and the clay with it. Main thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/edge_pixels.h"
#include "engine/render/frame_context.h"
#include "engine/render/lathe_pass.h"
#include "engine/render/lathe_pixels.h"
#include "engine/render/mover_pass.h"
#include "engine/render/mover_pixels.h"

namespace onggi::render {

class HostMoving {
  public:
    // Finds where hands and tools come to lie and in which light, and fills the frame's mover_tiles; and of
    // the clay, if the frame's is drawn here. `frame.built` must be this frame's, with the pass's choice of
    // faces, which must stay until they are drawn.
    void place(FrameContext& frame, const Scene& scene, const MoverPass& movers, const LathePass& lathe);

    // Into a picture that is another in every frame.
    void draw(const FrameContext& frame, const PictureCanvas& canvas);
    // Over a copy of a picture that is kept and its depth, where they are; both as large as the frame. The
    // device is idle. Errors: no memory for it.
    Result<void> draw_over(const FrameContext& frame, std::span<const std::uint32_t> pixels,
                           std::span<const float> depth);
    // That copy; only the tiles are good in which it draws.
    [[nodiscard]] const vk::Buffer& picture() const { return picture_; }
    [[nodiscard]] std::span<const std::uint8_t> tiles(const FrameContext& frame) const;
    // Its depth on the same tiles into the frame's, which is laid out to be copied into.
    void record_depth(const FrameContext& frame);

  private:
    Result<void> fit(const FrameContext& frame);
    void copy_under(const FrameContext& frame, std::span<const std::uint32_t> pixels,
                    std::span<const float> depth, const PictureCanvas& canvas);

    struct Part {
        std::size_t first_corner = 0;
        std::size_t corner_count = 0;
        std::span<const std::uint32_t> indices;  // the pass's
    };
    [[nodiscard]] std::span<const MoverCorner> corners_of(const Part& part) const {
        return std::span(corners_).subspan(part.first_corner, part.corner_count);
    }

    std::vector<MoverCorner> corners_;
    std::vector<Part> parts_;
    std::vector<LatheCorner> lathe_corners_;
    std::span<const std::uint32_t> slip_;  // the pass's
    EdgePixels edges_;
    vk::Buffer picture_;
    vk::Buffer depth_;
    std::vector<std::uint8_t> wanted_;
    std::vector<PixelRect> rects_;
};

}  // namespace onggi::render

// Hands and tools by the processor, where that is the device: lit at their vertices and drawn into a picture
// that the processor makes, before the device draws the lathe over both. Main thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/frame_context.h"
#include "engine/render/mover_pass.h"
#include "engine/render/mover_pixels.h"

namespace onggi::render {

class HostMovers {
  public:
    // Finds where they come to lie and in which light, and fills the frame's mover_tiles. `frame.built` must
    // be this frame's, with the pass's choice of faces, which must stay until they are drawn.
    void place(FrameContext& frame, const Scene& scene, const MoverPass& pass);

    // Into a picture that is another in every frame.
    void draw(const MoverCanvas& canvas) const;
    // Over a copy of a picture that is kept and its depth, where they are; both as large as the frame. The
    // device is idle. Errors: no memory for it.
    Result<void> draw_over(const FrameContext& frame, std::span<const std::uint32_t> pixels,
                           std::span<const float> depth);
    // That copy; only its mover_tiles are good.
    [[nodiscard]] const vk::Buffer& picture() const { return picture_; }
    // Its depth on the same tiles into the frame's, which is laid out to be copied into.
    void record_depth(const FrameContext& frame) const;

  private:
    Result<void> fit(const FrameContext& frame);

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
    vk::Buffer picture_;
    vk::Buffer depth_;
    std::vector<PixelRect> rects_;  // mover_tiles
};

}  // namespace onggi::render

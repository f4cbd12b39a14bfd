// What moves, by the processor where that is the device: hands, tools and the lathe, and their outlines
// smoothed, drawn into a picture that the processor makes. Main thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/cpu/framebuffer.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/pixels/edge_pixels.h"
#include "engine/render/pixels/lathe_pixels.h"
#include "engine/render/pixels/prop_pixels.h"
#include "engine/render/pixels/section_pixels.h"
#include "engine/render/shapes/prop_models.h"

namespace onggi::render {

class HostMoving {
  public:
    // Of a renderer that is described so.
    void create(const RendererDesc& desc);
    // Finds where all of it comes to lie and in which light, and fills the frame's prop_tiles. `frame.built`
    // must be this frame's, with the models' choice of faces, which must stay until they are drawn.
    void place(FrameContext& frame, const Scene& scene, const PropModels& models);

    // Over a copy of a picture that is kept and its depth, where something moves; both as large as the frame.
    // The device is idle. Errors: no memory for it.
    Result<void> draw_over(const FrameContext& frame, std::span<const std::uint32_t> pixels,
                           std::span<const float> depth);
    // That copy; only the tiles are good in which something moves.
    [[nodiscard]] const vk::Buffer& picture() const { return canvas_.picture(); }

  private:
    void draw(const FrameContext& frame, const PictureCanvas& canvas);
    void copy_under(const FrameContext& frame, std::span<const std::uint32_t> pixels,
                    std::span<const float> depth, const PictureCanvas& canvas);

    struct Part {
        std::size_t first_corner = 0;
        std::size_t corner_count = 0;
        std::span<const std::uint32_t> indices;  // the models'
    };
    [[nodiscard]] std::span<const PropCorner> corners_of(const Part& part) const {
        return std::span(corners_).subspan(part.first_corner, part.corner_count);
    }

    std::vector<PropCorner> corners_;
    std::vector<Part> parts_;
    std::vector<std::uint32_t> streaks_;  // see LatheLook
    StreakSize streak_size_;
    std::vector<LatheCorner> lathe_corners_;
    std::vector<SectionCorner> section_corners_;
    EdgePixels edges_;
    Framebuffer canvas_;
    std::vector<std::uint8_t> wanted_;
    std::vector<PixelRect> rects_;
};

}  // namespace onggi::render

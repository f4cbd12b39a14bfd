// Brings into a target what the processor made of a frame: a scene with the overlay on it, or an overlay that
// covers all; and of them only what the target does not show already. Main thread.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/cpu/damage_tracker.h"
#include "engine/render/cpu/painted_overlay.h"
#include "engine/render/frame/frame_context.h"

namespace onggi::render {

// As large as the frame.
struct HostPicture {
    const vk::Buffer& pixels;
    std::span<const std::uint64_t> numbers;  // of its tiles, see TileContents
    // Another that has its place on these tiles, and is another in every frame; the overlay may be laid on
    // it. Null: none.
    const vk::Buffer* instead = nullptr;
    std::span<const std::uint8_t> instead_on{};
};

// Calls with each of the two pictures and the rectangles where it is the one to be seen. `wanted` and `rects`
// are memory to work in.
template <typename Visit>
void for_parts(const HostPicture& picture, const TileGrid& grid, std::vector<std::uint8_t>& wanted,
               std::vector<PixelRect>& rects, Visit visit) {
    wanted.assign(grid.count(), 1);
    if (picture.instead != nullptr) {
        for (std::size_t tile = 0; tile < wanted.size(); ++tile)
            wanted[tile] = picture.instead_on[tile] == 0 ? 1 : 0;
        rects_of_tiles(grid, picture.instead_on, rects);
        for (const PixelRect& rect : rects)
            visit(*picture.instead, rect);
    }
    rects_of_tiles(grid, wanted, rects);
    for (const PixelRect& rect : rects)
        visit(picture.pixels, rect);
}

// Both as one, as large as the frame.
void copy_whole(const HostPicture& picture, const TileGrid& grid, std::span<std::uint32_t> into);

class HostFrame {
  public:
    // A picture with the overlay; lays the target out as colour. The device is idle.
    Result<void> record(const FrameContext& frame, const vk::TargetImage& target, const HostPicture& picture,
                        const PaintedOverlay& overlay);
    // The overlay alone, which covers everything.
    void record_covered(const FrameContext& frame, const vk::TargetImage& target,
                        const PaintedOverlay& overlay);

  private:
    void lay(const FrameContext& frame, const PaintedOverlay& overlay, const vk::Buffer& under,
             std::span<const std::uint8_t> tiles);
    void copy(const FrameContext& frame, const vk::Buffer& from, std::span<const std::uint8_t> tiles,
              const vk::TargetImage& into);

    HeldTargets targets_;
    TileWork work_;
    vk::Buffer laid_;  // what is shown with the overlay on it; only this frame's tiles of that are good
    std::vector<std::uint64_t> no_picture_;
    std::vector<PixelRect> rects_;
    std::vector<VkBufferImageCopy> regions_;
};

}  // namespace onggi::render

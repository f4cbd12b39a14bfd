// Brings into a target what the processor made of a frame: the shaded still life or a whole scene, the
// overlay where the device draws nothing under it, or an overlay that covers all; and of them only what the
// target does not show already. Main thread.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/frame_context.h"
#include "engine/render/held_tiles.h"
#include "engine/render/painted_overlay.h"

namespace onggi::render {

// As large as the frame.
struct HostPicture {
    const vk::Buffer& pixels;
    std::span<const std::uint64_t> numbers;  // of its tiles, see TileContents
    std::span<const std::uint8_t>
        moving{};  // tiles over which something is drawn before the overlay; empty: none
    // Of the moving tiles, those that another picture has in its place, which is another in every frame;
    // null: none.
    const vk::Buffer* instead = nullptr;
    std::span<const std::uint8_t> instead_on{};
    bool is_whole = false;  // what moves is in it: the overlay may be laid on it, too
};

class HostFrame {
  public:
    // A picture with the overlay; lays the target out as colour. Unless it is whole, whatever moves is drawn
    // next, and then the overlay on the tiles drawn_over(). The device is idle.
    Result<void> record(const FrameContext& frame, const vk::TargetImage& target, const HostPicture& picture,
                        const PaintedOverlay& overlay);
    [[nodiscard]] std::span<const std::uint8_t> drawn_over() const { return work_.drawn_over; }
    // The overlay alone; over a scene that has been drawn in this frame, or in place of one.
    void record_covered(const FrameContext& frame, const vk::TargetImage& target,
                        const PaintedOverlay& overlay, bool scene_is_drawn);

  private:
    void copy(const FrameContext& frame, const vk::Buffer& from, std::span<const std::uint8_t> tiles,
              const vk::TargetImage& into);

    HeldTargets targets_;
    TileWork work_;
    vk::Buffer laid_;  // a picture with the overlay on it; only this frame's laid-over tiles are good
    std::vector<std::uint64_t> no_picture_;
    std::vector<PixelRect> rects_;
    std::vector<VkBufferImageCopy> regions_;
};

}  // namespace onggi::render

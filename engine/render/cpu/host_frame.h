// Brings into a target what the processor made of a frame: a scene with the overlay on it, or an overlay that
// covers all; and of them only what the target does not show already. Main thread.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/frame/frame_context.h"
#include "engine/render/overlay.h"
#include "engine/render/pixels/overlay_paint.h"
#include "engine/vk/frame_target.h"

namespace onggi::render {

// Which tiles of a frame a target shows already, so that they are not brought there again.

// What a frame consists of, one entry a tile.
struct TileContents {
    // Of a picture's tiles, each of which has another number whenever it becomes another.
    std::span<const std::uint64_t> picture;
    // Not 0 where another picture has its place, which is another in every frame; empty: nowhere.
    std::span<const std::uint8_t> moving{};
    std::span<const std::uint64_t> overlay{};  // see OverlayTiles::content(); empty: none
};

// What of a frame has to be brought to a target, one entry a tile, 0 or not.
struct TileWork {
    std::vector<std::uint8_t> bare;         // the picture as it is
    std::vector<std::uint8_t> laid_over;    // the picture with the overlay laid over it
    std::vector<std::uint8_t> moves;        // what moves, as it is
    std::vector<std::uint8_t> moves_under;  // what moves, with the overlay laid over it
};

// What one target shows.
class DamageTracker {
  public:
    // Nothing of it is known.
    void forget() { picture_.clear(); }
    // What has to be done so that it shows this; from here on it does.
    void take_work(const TileContents& wanted, TileWork& work);

  private:
    std::vector<std::uint64_t> picture_;  // 0: something else
    std::vector<std::uint64_t> overlay_;
};

// What each of some targets shows that take turns, as the images of a window do.
class HeldTargets {
  public:
    // Of this target, in which the caller is about to make a frame. Forgotten if another has made one there
    // since.
    DamageTracker& held_by(const vk::TargetImage& target);

  private:
    struct Known {
        VkImage image = VK_NULL_HANDLE;
        std::uint64_t frame = 0;  // which of its frames was made last
        DamageTracker held;
    };
    std::vector<Known> known_;
};

// The overlay where the device is the processor: painted here, into pixels of its own, only where it has
// changed; HostFrame lays it over the picture.
class PaintedOverlay {
  public:
    // Paints what has changed. The device is idle. Null: no overlay.
    Result<void> fit(const FrameContext& frame, const Overlay* overlay);
    // What lies where; nothing where there is no overlay.
    [[nodiscard]] std::span<const std::uint64_t> content() const { return tiles_.content(); }
    // As large as the picture; only tiles on which something lies are good.
    [[nodiscard]] const vk::Buffer& painted() const { return painted_; }

  private:
    Result<void> fit_picture(const FrameContext& frame);

    vk::Buffer painted_;
    TileGrid grid_;
    OverlayPictures pictures_;
    OverlayTiles tiles_;
    std::vector<std::uint64_t> painted_content_;  // what of each tile was painted last
    std::vector<std::uint8_t> wanted_;
    std::vector<PixelRect> rects_;
};

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

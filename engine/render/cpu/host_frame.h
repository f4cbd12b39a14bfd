// Copies the processor's frame into a target: a scene with the overlay over it, or a covering overlay. Only
// tiles that the target does not show yet are copied. Main thread.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/cpu/picture_bands.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/overlay.h"
#include "engine/render/pixels/overlay_paint.h"
#include "engine/vk/frame_target.h"

namespace onggi::render {

// Damage tracking: which tiles of a frame a target shows already.

// The contents of a frame, one entry per tile.
struct TileContents {
    // Numbers of the picture's tiles; a tile gets a new number whenever its pixels change.
    std::span<const std::uint64_t> picture;
    // Not 0 where another picture, which changes in every frame, replaces this one; empty: nowhere.
    std::span<const std::uint8_t> moving{};
    std::span<const std::uint64_t> overlay{};  // see OverlayTiles::content(); empty: no overlay
};

// The tiles of a frame that must be copied to a target, by source; one entry per tile, 0 or 1.
struct TileWork {
    std::vector<std::uint8_t> bare;         // the picture
    std::vector<std::uint8_t> laid_over;    // the picture with the overlay over it
    std::vector<std::uint8_t> moves;        // the moving picture
    std::vector<std::uint8_t> moves_under;  // the moving picture with the overlay over it
};

// The tiles that one target shows.
class DamageTracker {
  public:
    // Marks all tiles as unknown.
    void forget() { picture_.clear(); }
    // Computes the tiles to copy so that the target shows `wanted`, and records that it does.
    void take_work(const TileContents& wanted, TileWork& work);

  private:
    std::vector<std::uint64_t> picture_;  // 0: unknown
    std::vector<std::uint64_t> overlay_;
};

// A DamageTracker for each target of a set that takes turns, such as a window's images.
class HeldTargets {
  public:
    // Returns the tracker of this target, in which the caller is about to make a frame. All its tiles are
    // unknown if another renderer has drawn to the target since.
    DamageTracker& held_by(const vk::TargetImage& target);

  private:
    struct Known {
        VkImage image = VK_NULL_HANDLE;
        std::uint64_t frame = 0;  // number of the last frame made in it
        DamageTracker held;
    };
    std::vector<Known> known_;
};

// The overlay for a software device: the processor paints changed tiles into a separate buffer, and HostFrame
// composes it over the picture.
class PaintedOverlay {
  public:
    // Repaints the changed tiles. Null: no overlay. The device is idle.
    Result<void> fit(const FrameContext& frame, const Overlay* overlay);
    // The content of each tile; empty without an overlay.
    [[nodiscard]] std::span<const std::uint64_t> content() const { return tiles_.content(); }
    // As large as the picture. Only tiles with overlay content are valid.
    [[nodiscard]] const vk::Buffer& painted() const { return painted_; }

  private:
    Result<void> fit_picture(const FrameContext& frame);

    vk::Buffer painted_;
    TileGrid grid_;
    OverlayPictures pictures_;
    OverlayTiles tiles_;
    std::vector<std::uint64_t> painted_content_;  // content of each tile when it was last painted
    std::vector<std::uint8_t> wanted_;
    std::vector<PixelRect> rects_;
};

// A finished picture, as large as the frame.
struct HostPicture {
    const vk::Buffer& pixels;
    std::span<const std::uint64_t> numbers;  // of its tiles, see TileContents
    // Another picture that replaces this one on the tiles of `instead_on` and changes in every frame; the
    // overlay may be composed over it. Null: no such picture.
    const vk::Buffer* instead = nullptr;
    std::span<const std::uint8_t> instead_on{};
};

// Calls `visit` with each of the two pictures and disjoint rectangles where it is visible, on either thread
// of for_bands(). `wanted` and `rects` are scratch memory.
template <typename Visit>
void for_parts(const FrameContext& frame, const HostPicture& picture, const TileGrid& grid,
               std::vector<std::uint8_t>& wanted, std::vector<PixelRect>& rects, Visit visit) {
    const auto visit_all = [&](const vk::Buffer& pixels) {
        for_bands(frame, [&](int, const RowSpan& rows) {
            for (const PixelRect& rect : rects) {
                if (const PixelRect part = within(rect, rows); part.height > 0) visit(pixels, part);
            }
        });
    };
    wanted.assign(grid.count(), 1);
    if (picture.instead != nullptr) {
        for (std::size_t tile = 0; tile < wanted.size(); ++tile)
            wanted[tile] = picture.instead_on[tile] == 0 ? 1 : 0;
        rects_of_tiles(grid, picture.instead_on, rects);
        visit_all(*picture.instead);
    }
    rects_of_tiles(grid, wanted, rects);
    visit_all(picture.pixels);
}

// Merges both pictures into one, as large as the frame.
void copy_whole(const FrameContext& frame, const HostPicture& picture, const TileGrid& grid,
                std::span<std::uint32_t> into);

class HostFrame {
  public:
    // Composes the picture and the overlay; leaves the target in the colour layout. The device is idle.
    Result<void> record(const FrameContext& frame, const vk::TargetImage& target, const HostPicture& picture,
                        const PaintedOverlay& overlay);
    // Copies only the overlay, which covers everything.
    void record_covered(const FrameContext& frame, const vk::TargetImage& target,
                        const PaintedOverlay& overlay);

  private:
    void lay(const FrameContext& frame, const PaintedOverlay& overlay, const vk::Buffer& under,
             std::span<const std::uint8_t> tiles);
    void copy(const FrameContext& frame, const vk::Buffer& from, std::span<const std::uint8_t> tiles,
              const vk::TargetImage& into);

    HeldTargets targets_;
    TileWork work_;
    vk::Buffer laid_;  // pictures with the overlay over them; only this frame's tiles are valid
    std::vector<std::uint64_t> no_picture_;
    std::vector<PixelRect> rects_;
    std::vector<VkBufferImageCopy> regions_;
};

}  // namespace onggi::render

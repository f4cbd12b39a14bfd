// Which tiles of a frame a target shows already, so that they are not brought there again. Any thread; one
// user at a time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/vk/frame_target.h"

namespace onggi::render {

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

}  // namespace onggi::render

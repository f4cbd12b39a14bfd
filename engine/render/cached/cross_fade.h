// From the last picture of a view to those of the next, one mixed into the other. Main thread.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/cached/host_frame.h"
#include "engine/render/cached/tile_numbers.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/shapes/tiles.h"

namespace onggi::render {

class CrossFade {
  public:
    // `last` is what is left, perhaps this fade's own picture. The device is idle. Errors: no memory.
    Result<void> begin(const FrameContext& frame, const HostPicture& last);
    // Gives back the memory. The device is idle.
    void end();
    [[nodiscard]] bool is_on() const { return before_.size() > 0; }

    // As much of `now` as the share says, 0 to 1, over what was left; it is on. The device is idle.
    void mix(const HostPicture& now, float share, TileNumbers& numbers);
    // What came of it.
    [[nodiscard]] HostPicture picture() const { return {mixed_, numbers_}; }

  private:
    TileGrid grid_;
    vk::Buffer before_;
    vk::Buffer mixed_;
    std::vector<std::uint64_t> numbers_;  // of its tiles, all of which are others in every frame
    std::vector<std::uint8_t> wanted_;
    std::vector<PixelRect> rects_;
};

}  // namespace onggi::render

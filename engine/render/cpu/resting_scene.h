// A scene that stands still while a screen that covers it comes or goes: made once more, and from then on
// brought into the frames with the overlay on it. Main thread.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/render/cpu/host_frame.h"
#include "engine/render/cpu/tile_numbers.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/shapes/tiles.h"

namespace onggi::render {

class RestingScene {
  public:
    void forget() { is_here_ = false; }
    // No overlay lies on the scene yet: keeps a copy, unless one is here.
    Result<void> keep(const FrameContext& frame, const HostPicture& scene, TileNumbers& numbers);
    [[nodiscard]] bool is_here() const { return is_here_; }
    [[nodiscard]] HostPicture picture() const { return {picture_, numbers_}; }

  private:
    Result<void> fit(const FrameContext& frame);

    bool is_here_ = false;
    TileGrid grid_;
    vk::Buffer picture_;
    std::vector<std::uint64_t> numbers_;
};

}  // namespace onggi::render

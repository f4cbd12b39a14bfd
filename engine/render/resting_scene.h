// A scene that stands still while a screen that covers it comes or goes: drawn once more, read back, and from
// then on brought into the frames by the processor with the overlay on it. Main thread.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/frame_context.h"
#include "engine/render/host_frame.h"
#include "engine/render/host_shade.h"
#include "engine/vk/frame_target.h"

namespace onggi::render {

class RestingScene {
  public:
    void forget() { state_ = State::kNothing; }
    // The scene has been drawn into the target, which is laid out as colour, and nothing over it: copies it
    // to where the host reads it, but for what was shaded there and nothing was drawn over (null: it was
    // not).
    Result<void> record_reading(const FrameContext& frame, const vk::TargetImage& target,
                                const HostShade* shade);
    // The host has drawn the scene, and no overlay lies on it yet: keeps a copy.
    Result<void> keep(const FrameContext& frame, const HostPicture& scene);
    // Whether the scene is here. The device is idle, and nothing has been shaded since it was read.
    [[nodiscard]] bool take(const HostShade& shade);
    [[nodiscard]] HostPicture picture() const { return {picture_, numbers_}; }

  private:
    enum class State { kNothing, kOnTheWay, kHere };

    Result<void> fit(const FrameContext& frame);
    void copy(const vk::Buffer& from, std::span<const std::uint8_t> tiles);
    void arrive();

    State state_ = State::kNothing;
    TileGrid grid_;
    vk::Buffer picture_;
    std::vector<std::uint64_t> numbers_;
    std::uint64_t last_number_ = 0;
    std::vector<std::uint8_t> is_shaded_;  // by the host, and nothing over it; one entry a tile
    std::vector<std::uint8_t> is_drawn_;   // the others
    std::vector<PixelRect> rects_;
    std::vector<VkBufferImageCopy> regions_;
};

}  // namespace onggi::render

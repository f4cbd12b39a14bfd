// The cached still life with the shade on it, where the device is the processor: its layers are read back
// once, and from then on the picture is kept here, shaded again where the shade has changed, and copied into
// a target where that shows something else. Until the layers have been read, which takes a frame, the caller
// copies the still life and draws the shade instead. Main thread.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/render/frame_context.h"
#include "engine/render/shade_tiles.h"
#include "engine/render/shadow_mask.h"
#include "engine/vk/frame_target.h"

namespace onggi::render {

class HostShade {
  public:
    // Makes room for a picture of this size. The device is idle.
    Result<void> fit(const FrameContext& frame);
    // The layers are drawn anew.
    void forget() { state_ = State::kNothing; }
    // Copies the layers, which have been drawn, to where the host reads them, unless they are there. Not
    // those of a picture so narrow that nobody sees what is in it.
    void read_layers(const FrameContext& frame);

    // The device is idle. True when the layers are here and `shadow` has been laid over them, which takes
    // time only where it is another; `frame.built` must be this frame's.
    [[nodiscard]] bool shade(FrameContext& frame, std::uint64_t shadow);
    // What shade() made into the target, whole but for what is laid over it, and lays it out as colour.
    void record(const FrameContext& frame, const vk::TargetImage& target,
                std::span<const std::uint64_t> overlay);
    // After record(): the tiles on which the overlay has to be drawn, one entry each.
    [[nodiscard]] std::span<const std::uint8_t> overlay_wanted() const { return overlay_wanted_; }

  private:
    enum class State {
        kNothing,
        kOnTheWay,  // with the commands of the frame that is being made
        kHere
    };
    // An image that was recorded for, and in which of its frames that was.
    struct Target {
        VkImage image = VK_NULL_HANDLE;
        std::uint64_t frame = 0;
        HeldTiles held;
    };
    void take_layers();
    HeldTiles& held_by(const vk::TargetImage& target);

    State state_ = State::kNothing;
    VkExtent2D extent_{};
    vk::Buffer with_key_;
    vk::Buffer without_key_;
    vk::Buffer places_;  // coordinates in the mask; turned into mask_place() when they have come
    vk::Buffer shaded_;
    std::unique_ptr<ShadowMask> mask_ = std::make_unique<ShadowMask>();
    std::unique_ptr<ShadowMask> mask_before_ = std::make_unique<ShadowMask>();
    std::uint64_t mask_of_ = 0;
    bool has_mask_ = false;
    ShadeTiles tiles_;  // of `shaded_`
    std::vector<Target> targets_;
    std::vector<std::uint8_t> overlay_wanted_;
    std::vector<PixelRect> rects_;
    std::vector<VkBufferImageCopy> regions_;
};

}  // namespace onggi::render

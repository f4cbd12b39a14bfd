// The cached still life with the shade on it, where the device is the processor: its layers are read back
// once, and from then on the picture is kept here and shaded again where the shade has changed. Until the
// layers have been read, which takes a frame, the caller copies the still life and draws the shade instead.
// Main thread.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/render/frame_context.h"
#include "engine/render/shade_tiles.h"
#include "engine/render/shadow_mask.h"

namespace onggi::render {

class HostShade {
  public:
    // Makes room for a picture of this size. The device is idle.
    Result<void> fit(const FrameContext& frame);
    // The layers are drawn anew.
    void forget() { state_ = State::kNothing; }
    // Nothing will be shaded for a while: gives its memory back until the next fit(). The device is idle.
    void let_go();
    // A picture may be so narrow that nobody sees what is in it.
    [[nodiscard]] bool is_wide_enough() const;
    // Copies the layers, which have been drawn, to where the host reads them, unless they are there. Not
    // those of a picture that is not wide enough.
    void read_layers(const FrameContext& frame);

    // The device is idle. True when the layers are here and `shadow` has been laid over them, which takes
    // time only where it is another; `frame.built` must be this frame's.
    [[nodiscard]] bool shade(FrameContext& frame, std::uint64_t shadow);
    // As large as the picture: what shade() made, and which tile of it is which.
    [[nodiscard]] const vk::Buffer& shaded() const { return shaded_; }
    [[nodiscard]] const ShadeTiles& tiles() const { return tiles_; }

  private:
    enum class State {
        kNothing,
        kOnTheWay,  // with the commands of the frame that is being made
        kHere
    };
    void take_layers();

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
    std::vector<PixelRect> rects_;
};

}  // namespace onggi::render

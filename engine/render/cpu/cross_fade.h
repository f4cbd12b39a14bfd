// From the last picture of a view to those of the next, one mixed into the other; in the memory of the view
// that is left. Main thread.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/render/cpu/host_frame.h"
#include "engine/render/cpu/kept_view.h"
#include "engine/render/cpu/tile_numbers.h"
#include "engine/render/shapes/tiles.h"

namespace onggi::render {

class CrossFade {
  public:
    // `last` is what is left; it may lie in the first of what is lent, which stays where it is until end().
    void begin(const TileGrid& grid, const HostPicture& last, const KeptView::Lent& lent);
    void end() { before_ = mixed_ = nullptr; }
    [[nodiscard]] bool is_on() const { return mixed_ != nullptr; }

    // As much of `now` as the fraction says, 0 to 1, over what was left; it is on. The device is idle.
    void mix(const HostPicture& now, float fraction, TileNumbers& numbers);
    // What came of it.
    [[nodiscard]] HostPicture picture() const { return {*mixed_, numbers_}; }

  private:
    TileGrid grid_;
    const vk::Buffer* before_ = nullptr;
    const vk::Buffer* mixed_ = nullptr;
    std::vector<std::uint64_t> numbers_;  // of its tiles, all of which are others in every frame
    std::vector<std::uint8_t> wanted_;
    std::vector<PixelRect> rects_;
};

}  // namespace onggi::render

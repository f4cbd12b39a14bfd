// The paintings that an overlay's draw list names by their place in the atlas, as they are in memory: for who
// paints the overlay without a texture. Main thread.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>

#include "engine/ui/atlas.h"

namespace onggi::render {

class OverlayPictures {
  public:
    struct Picture {
        ui::Atlas::Upload placed;
        std::uint64_t number = 0;  // no other picture ever had it
    };

    // These come, over whatever lay in their places in an atlas of this size; of one of another size nothing
    // is left.
    void take(std::span<const ui::Atlas::Upload> uploads, int side_px);
    // The picture with this upper left corner in the atlas; null: none.
    [[nodiscard]] const Picture* at(vec2 corner_px) const;
    // Another whenever any of them is.
    [[nodiscard]] std::uint64_t state() const { return last_number_; }

  private:
    std::unordered_map<std::uint64_t, Picture> pictures_;  // by corner
    std::uint64_t last_number_ = 0;
    int side_px_ = 0;
};

}  // namespace onggi::render

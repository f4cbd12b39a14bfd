// What every encoder of pictures asks of one. Inside the room.
#pragma once

#include "engine/asset/image.h"

namespace onggi::asset {

// Its sides are within 1..kMaxImageSide, and rgba holds them.
[[nodiscard]] inline bool is_whole(const Image& image) {
    return image.width >= 1 && image.width <= kMaxImageSide && image.height >= 1 &&
           image.height <= kMaxImageSide &&
           image.rgba.size() == std::size_t{4} * static_cast<std::size_t>(image.width) *
                                    static_cast<std::size_t>(image.height);
}

}  // namespace onggi::asset

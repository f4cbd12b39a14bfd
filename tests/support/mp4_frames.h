// The pictures of an MP4 film, as a player shows them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/asset/image.h"

namespace onggi::test {

struct Mp4Frames {
    std::vector<asset::Image> images;
    int lasts_ms = 0;
    std::vector<int> keys;  // indices of the pictures that can be decoded alone
};

// Throws std::runtime_error where a box is damaged, the index does not precede the pictures, two places state
// other sizes or durations, or OpenH264's decoder refuses a picture.
[[nodiscard]] Mp4Frames mp4_frames(std::span<const std::byte> file);

}  // namespace onggi::test

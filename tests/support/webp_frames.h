// The pictures of an animated WebP, as a viewer shows them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/asset/image.h"

namespace onggi::test {

struct WebpFrames {
    std::vector<asset::Image> images;
    std::vector<int> ends_ms;  // the end time of each
    int plays = 0;             // 0: without end
};

// Throws std::runtime_error where libwebp refuses the bytes.
[[nodiscard]] WebpFrames webp_frames(std::span<const std::byte> file);
// The mean absolute difference of the bytes of two pictures of one size.
[[nodiscard]] double mean_difference(const asset::Image& a, const asset::Image& b);

}  // namespace onggi::test

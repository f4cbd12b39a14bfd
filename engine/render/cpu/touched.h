// Memory that will be written to for the first time where a frame has no time for it. Main thread.
#pragma once

#include <algorithm>
#include <cstddef>

#include "engine/vk/buffer.h"

namespace onggi::render {

// The system gives a page when it is first written to, which takes a virtual machine up to 15 microseconds:
// 14 ms a picture of 1280x720.
inline void touch(const vk::Buffer& buffer) {
    std::fill_n(buffer.mapped(), buffer.size(), std::byte{0});
}

}  // namespace onggi::render

// Photographs in memory for the CPU backend. Any thread. Texels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/byte_order.h"

namespace onggi::render {

// A photograph in host memory: texels of four bytes, in the picture's encoding and byte order. A border
// around it holds the texels that interpolation beside the last texel reads.
class HostPhotograph {
  public:
    HostPhotograph() = default;
    // rgba: width x height pixels.
    HostPhotograph(int width, int height, std::span<const std::uint8_t> rgba, ByteOrder order);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] const std::uint32_t* first() const { return texels_.data() + width_ + 1; }

  private:
    std::span<std::uint32_t> texels();
    void fill_border();

    int width_ = 0;
    int height_ = 0;
    std::vector<std::uint32_t> texels_;
};

// The two photographs of a background.
struct HostBackground {
    HostPhotograph key;
    HostPhotograph ambient;
};

}  // namespace onggi::render

// Photographs where the processor finds them, to be laid by it. Any thread. Texels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/byte_order.h"

namespace onggi::render {

// One photograph as the host reads it: texels of four bytes, with the transfer and in the byte order of the
// picture. Round them lies what a look between two of them may touch beside the last.
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

// A background's pair.
struct HostBackground {
    HostPhotograph key;
    HostPhotograph ambient;
};

}  // namespace onggi::render

// Numbers for pictures of tiles, see DamageTracker. Main thread.
#pragma once

#include <cstdint>

namespace onggi::render {

// None of them is given twice, so that no target takes one picture for another. The first is 1.
class TileNumbers {
  public:
    [[nodiscard]] std::uint64_t next() { return ++last_; }

  private:
    std::uint64_t last_ = 0;
};

}  // namespace onggi::render

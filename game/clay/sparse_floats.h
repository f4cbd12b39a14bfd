// A long array of floats most of which stay 0. Pages that were never written take no memory, and a copy skips
// pages that are 0 on both sides. Allocates when it is made or copied, never later. Any one thread at a time.
#pragma once

#include <cstddef>
#include <memory>

namespace onggi::clay {

class SparseFloats {
  public:
    explicit SparseFloats(std::size_t count);
    SparseFloats(const SparseFloats& other);
    SparseFloats& operator=(const SparseFloats& other);
    SparseFloats(SparseFloats&& other) noexcept;
    SparseFloats& operator=(SparseFloats&& other) noexcept;
    ~SparseFloats() = default;

    [[nodiscard]] float* data() { return floats_.get(); }
    [[nodiscard]] const float* data() const { return floats_.get(); }
    [[nodiscard]] std::size_t size() const { return size_; }

    // Commits all pages now, so that no later write has to. The values stay.
    void take_memory() noexcept;

  private:
    struct Free {
        void operator()(float* floats) const noexcept;
    };

    std::size_t size_;
    std::unique_ptr<float, Free> floats_;
};

}  // namespace onggi::clay

#include "game/clay/sparse_floats.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <utility>

#include "engine/core/within_memory.h"

namespace onggi::clay {
namespace {

constexpr std::size_t kPage = 4096 / sizeof(float);

// Zeroed memory from the system. Pages of a large block take memory only when they are written.
float* zeros(std::size_t count) {
    void* const memory = std::calloc(std::max<std::size_t>(count, 1), sizeof(float));
    if (memory == nullptr) refuse_memory();
    return static_cast<float*>(memory);
}

// Compares bits, so that -0 is copied too.
bool is_zero(std::span<const float> floats) {
    return std::all_of(floats.begin(), floats.end(),
                       [](float value) { return std::bit_cast<std::uint32_t>(value) == 0; });
}

}  // namespace

SparseFloats::SparseFloats(std::size_t count) : size_(count), floats_(zeros(count)) {}

// The new floats are still zero. They are not read: reading a fresh page is not free on every system.
SparseFloats::SparseFloats(const SparseFloats& other) : SparseFloats(other.size_) {
    for (std::size_t at = 0; at < size_; at += kPage) {
        const std::span<const float> from(other.data() + at, std::min(kPage, size_ - at));
        if (!is_zero(from)) std::copy(from.begin(), from.end(), data() + at);
    }
}

SparseFloats& SparseFloats::operator=(const SparseFloats& other) {
    if (this == &other) return *this;
    if (size_ != other.size_) {
        floats_.reset(zeros(other.size_));
        size_ = other.size_;
    }
    for (std::size_t at = 0; at < size_; at += kPage) {
        const std::size_t count = std::min(kPage, size_ - at);
        const std::span<const float> from(other.data() + at, count);
        const std::span<float> to(data() + at, count);
        if (!is_zero(from) || !is_zero(to)) std::copy(from.begin(), from.end(), to.begin());
    }
    return *this;
}

SparseFloats::SparseFloats(SparseFloats&& other) noexcept
    : size_(std::exchange(other.size_, 0)),
      floats_(std::move(other.floats_)) {}

SparseFloats& SparseFloats::operator=(SparseFloats&& other) noexcept {
    size_ = std::exchange(other.size_, 0);
    floats_ = std::move(other.floats_);
    return *this;
}

void SparseFloats::take_memory() noexcept {
    for (std::size_t at = 0; at < size_; at += kPage) {
        volatile float& first = data()[at];
        const float value = first;
        first = value;
    }
}

void SparseFloats::Free::operator()(float* floats) const noexcept {
    std::free(floats);
}

}  // namespace onggi::clay

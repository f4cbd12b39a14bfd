// Passes the newest of a stream of large values from one thread to another; unread older values are
// overwritten. One writer thread, one reader thread, both wait-free: no lock, no retry, no allocation. A
// preempted writer never delays the reader, unlike a seqlock, whose reader would spin.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace onggi::jobs {

// The size of a cache line: writes of two cores to one line slow both down.
constexpr std::size_t kCacheLine = 64;

// Three slots: the writer owns one, the reader owns one, and each swaps its slot with the third by an atomic
// exchange. A slot that returns to the writer keeps its old content (and its vectors their capacity), so a
// payload with preallocated vectors is filled without allocating.
template <typename T>
class TripleBuffer {
  public:
    // Every slot starts as a copy of `initial`, which is also what the reader sees until the first publish.
    explicit TripleBuffer(const T& initial = T{}) : slots_{Slot{initial}, Slot{initial}, Slot{initial}} {}
    // Every slot starts as a result of `make`, which keeps its vectors' reserved capacity; a copy would not.
    template <typename Make>
    requires std::is_invocable_r_v<T, const Make&>
    explicit TripleBuffer(const Make& make) : slots_{Slot{make()}, Slot{make()}, Slot{make()}} {}

    TripleBuffer(const TripleBuffer&) = delete;
    TripleBuffer& operator=(const TripleBuffer&) = delete;

    // Writer thread. The slot to fill; it holds an older value, so set every field.
    [[nodiscard]] T& writing() noexcept { return slots_[write_index_].value; }
    // Writer thread. Publishes the filled slot; writing() then returns another one.
    void publish() noexcept {
        const std::uint8_t before =
            middle_.exchange(static_cast<std::uint8_t>(write_index_ | kFresh), std::memory_order_acq_rel);
        write_index_ = static_cast<std::uint8_t>(before & kIndexMask);
    }

    // Reader thread. Takes the newest value if one was published since the last call. Returns whether there
    // was one.
    bool acquire() noexcept {
        if ((middle_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
        const std::uint8_t before = middle_.exchange(read_index_, std::memory_order_acq_rel);
        read_index_ = static_cast<std::uint8_t>(before & kIndexMask);
        return true;
    }
    // Reader thread. The value last acquired; it does not change until the next acquire().
    [[nodiscard]] const T& reading() const noexcept { return slots_[read_index_].value; }

  private:
    struct alignas(kCacheLine) Slot {
        T value;
    };
    static constexpr std::uint8_t kIndexMask = 3;
    static constexpr std::uint8_t kFresh = 4;  // the slot in the middle has not been read yet

    std::array<Slot, 3> slots_;
    alignas(kCacheLine) std::uint8_t write_index_ = 0;
    alignas(kCacheLine) std::atomic<std::uint8_t> middle_{1};
    alignas(kCacheLine) std::uint8_t read_index_ = 2;
};

}  // namespace onggi::jobs

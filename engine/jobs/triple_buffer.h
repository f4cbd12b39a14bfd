// Hands the newest of a stream of large values from one thread to another: the newest wins, older ones that
// nobody fetched are overwritten. One writer thread, one reader thread, both wait-free: no lock, no retry, no
// allocation, and a preempted writer never holds the reader up (why not a seqlock: its reader spins then).
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace onggi::jobs {

// The size of what two cores fight over when they write side by side.
constexpr std::size_t kCacheLine = 64;

// Three slots: the writer owns one, the reader owns one, and the third lies between them, changing hands by
// one atomic exchange. A slot keeps its old content (and its vectors their capacity) when it comes back to
// the writer, so a payload with preallocated vectors is filled without allocating.
template <typename T>
class TripleBuffer {
  public:
    // Every slot starts as a copy of `initial`, which is also what the reader sees until the first publish.
    explicit TripleBuffer(const T& initial = T{}) : slots_{Slot{initial}, Slot{initial}, Slot{initial}} {}
    // Every slot starts as what `make` gives, which keeps the room that its vectors have reserved: a copy
    // would not.
    template <typename Make>
    requires std::is_invocable_r_v<T, const Make&>
    explicit TripleBuffer(const Make& make) : slots_{Slot{make()}, Slot{make()}, Slot{make()}} {}

    TripleBuffer(const TripleBuffer&) = delete;
    TripleBuffer& operator=(const TripleBuffer&) = delete;

    // Writer thread. The slot to fill; it holds some older value, so fill all of it.
    [[nodiscard]] T& writing() noexcept { return slots_[write_index_].value; }
    // Writer thread. Makes the filled slot the newest; writing() is another one from now on.
    void publish() noexcept {
        const std::uint8_t before =
            middle_.exchange(static_cast<std::uint8_t>(write_index_ | kFresh), std::memory_order_acq_rel);
        write_index_ = static_cast<std::uint8_t>(before & kIndexMask);
    }

    // Reader thread. Takes the newest value if there is one since the last call, and says whether there was.
    bool acquire() noexcept {
        if ((middle_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
        const std::uint8_t before = middle_.exchange(read_index_, std::memory_order_acq_rel);
        read_index_ = static_cast<std::uint8_t>(before & kIndexMask);
        return true;
    }
    // Reader thread. The value last acquired; it stays as it is until the next acquire().
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

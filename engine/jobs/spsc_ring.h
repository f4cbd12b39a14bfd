// A bounded FIFO queue from one thread to another, for streams that must not lose values silently: commands,
// tick records, log items. One producer thread, one consumer thread, both wait-free. A full ring refuses a
// value; the caller decides whether to drop and count it.
#pragma once

#include <atomic>
#include <bit>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/jobs/triple_buffer.h"

namespace onggi::jobs {

// Each side caches the other's index and reads the shared one only when the cached one says full (or empty):
// most calls touch no cache line that the other side writes.
template <typename T>
class SpscRing {
    static_assert(std::is_nothrow_copy_assignable_v<T> && std::is_nothrow_move_assignable_v<T>);

  public:
    // Any thread. Holds at least `capacity` values (rounded up to a power of two); the only allocation.
    explicit SpscRing(std::size_t capacity)
        : slots_(std::bit_ceil(capacity < 2 ? std::size_t{2} : capacity)) {}

    SpscRing(const SpscRing&) = delete;
    SpscRing& operator=(const SpscRing&) = delete;

    [[nodiscard]] std::size_t capacity() const noexcept { return slots_.size(); }

    // Producer thread. Returns false and does nothing if the ring is full.
    [[nodiscard]] bool try_push(const T& value) noexcept {
        const std::size_t tail = producer_.own.load(std::memory_order_relaxed);
        if (tail - producer_.other == slots_.size()) {
            producer_.other = consumer_.own.load(std::memory_order_acquire);
            if (tail - producer_.other == slots_.size()) return false;
        }
        slots_[tail & (slots_.size() - 1)] = value;
        producer_.own.store(tail + 1, std::memory_order_release);
        return true;
    }

    // Consumer thread. Returns false and leaves `value` unchanged if the ring is empty. The slot is cleared:
    // a copy left there would keep a shared pointer's object alive until the slot is reused.
    [[nodiscard]] bool try_pop(T& value) noexcept {
        const std::size_t head = consumer_.own.load(std::memory_order_relaxed);
        if (head == consumer_.other) {
            consumer_.other = producer_.own.load(std::memory_order_acquire);
            if (head == consumer_.other) return false;
        }
        value = std::move(slots_[head & (slots_.size() - 1)]);
        consumer_.own.store(head + 1, std::memory_order_release);
        return true;
    }

  private:
    // Indices are never reduced and are masked on use, so full and empty differ.
    struct alignas(kCacheLine) Side {
        std::atomic<std::size_t> own{0};  // written by this side, read by both
        std::size_t other = 0;            // cached copy of the other side's index
    };
    std::vector<T> slots_;
    Side producer_;
    Side consumer_;
};

}  // namespace onggi::jobs

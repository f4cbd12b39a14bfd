// Watches the haptic loop from another thread and removes the force when the loop hangs. A device keeps the
// last force that it was sent, so it would go on pushing if the loop hangs or the kernel does not run it.
//
// It watches the picture too. While the screen hangs, no key or button works; after two seconds the hand
// counts as absent, and later the force returns through the ramp.
//
// While no device is plugged in that could push, the loop ticks in bursts (rest()), and the thread checks
// every 8 ms. The force of a device that is plugged in ramps up from none, which takes longer than that.
//
// The timeout is 5 ms (SAFETY.md). The thread checks every ms, on the other cores, with real-time priority if
// granted; without it the kernel may delay it by some ms. A USB device receives it with its next packet: HID
// reports go out every 4 ms, so 5 + 1 + 4 ms.
#pragma once

#include <atomic>
#include <cstdint>

#include "engine/haptics/haptic_device.h"
#include "engine/jobs/io_thread.h"

namespace onggi::haptics {

struct WatchdogOptions {
    std::int64_t loop_silence_ns = 5'000'000;
    std::int64_t picture_silence_ns = 2'000'000'000;
    // The loop may be slow by design: the timeout is at least least_periods of its periods.
    double rate_hz = 4000.0;
    double least_periods = 3.0;
};

class Watchdog final : public jobs::IoWork {
  public:
    // The device must outlive the watchdog and be open while rounds run.
    Watchdog(HapticDevice& device, const WatchdogOptions& options);

    // Haptic thread, once a tick. Wait-free.
    void beat() noexcept { count_up(beats_); }
    // Haptic thread: whether the loop ticks in bursts of kRestNs, which it may do only while there are no
    // motors.
    void rest(bool rests) noexcept { rests_.store(rests, std::memory_order_relaxed); }
    static constexpr std::int64_t kRestNs = 4'000'000;
    static constexpr std::int64_t kLookAtRestNs = 2 * kRestNs;
    // Haptic thread: the number of times that the loop was found hanging and the device was silenced.
    [[nodiscard]] std::uint32_t silences() const noexcept {
        return silences_.load(std::memory_order_acquire);
    }
    // Haptic thread: the picture hangs.
    [[nodiscard]] bool picture_stands_still() const noexcept {
        return picture_stands_still_.load(std::memory_order_relaxed);
    }
    // Main thread, once a frame. Wait-free. The watch begins with the first call.
    void picture_is_alive() noexcept { count_up(pictures_); }

    // The watchdog's thread; times in ns of a monotonic clock.
    [[nodiscard]] std::int64_t round(std::int64_t now_ns) noexcept override;
    void finish() noexcept override {}

  private:
    // One writer each: no read-modify-write is needed.
    static void count_up(std::atomic<std::uint64_t>& counter) noexcept {
        counter.store(counter.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    }

    // The time for which a counter has not changed.
    struct Watched {
        std::uint64_t last = 0;
        std::int64_t since_ns = 0;

        [[nodiscard]] bool stands_still(std::uint64_t count, std::int64_t now_ns,
                                        std::int64_t for_ns) noexcept;
    };

    HapticDevice& device_;
    std::int64_t loop_silence_ns_;
    std::int64_t picture_silence_ns_;
    std::atomic<std::uint64_t> beats_{0};
    std::atomic<std::uint64_t> pictures_{0};
    std::atomic<std::uint32_t> silences_{0};
    std::atomic<bool> picture_stands_still_{false};
    std::atomic<bool> rests_{false};
    // The watchdog's thread only.
    Watched loop_;
    Watched picture_;
    bool is_silent_ = false;
    bool has_asked_for_time_ = false;
};

}  // namespace onggi::haptics

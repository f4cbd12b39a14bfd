// The last gate before a device's motors, on its I/O thread: passes the haptic thread's force or reduces it.
// It covers what the safety chain of the tick (safety_chain.h, SAFETY.md) cannot know: that the tick has
// stopped, or that the device was just plugged in. Pure; one thread at a time. N, ns.
#pragma once

#include <cstdint>

#include "engine/haptics/hid/device_input.h"
#include "engine/haptics/hid/hid_driver.h"
#include "engine/haptics/safety_chain.h"

namespace onggi::haptics::hid {

struct ForceGateLimits {
    double peak_n = kKioskPeakForceN;
    // If no new order arrives for this long, the force is zero. Two ticks of the slowest rate (100 Hz). USB
    // devices are sent forces every 4 ms, so they cannot meet the 5 ms that a faster bus could.
    std::int64_t silence_ns = 20 * kMs;
    // After this long the loop counts as dead, and the effects that a device runs by itself are stopped.
    std::int64_t starved_ns = 100 * kMs;
    // The time from zero to full force after plugging in, and after any silence ...
    std::int64_t ramp_ns = 1000 * kMs;
    // ... which begins only at a small order: if a device is plugged in while the tool is deep in the work,
    // it stays without force until the tool has come out.
    double small_n = 0.2;
};

class ForceGate {
  public:
    explicit ForceGate(const ForceGateLimits& limits = {}) : limits_(limits) {}

    // A device was opened, or its input went silent: forces start again from zero.
    void restart() noexcept {
        ramp_since_ns_ = kNotYet;
        fraction_ = 0.0;
    }

    // Returns the order that may be sent: its force zero, shortened or unchanged, in the same direction.
    [[nodiscard]] ForceOrder passed(const ForceOrder& order, std::int64_t now_ns) noexcept;
    // The fraction of the force that the last passed() kept, 0 to 1; 0 after restart().
    [[nodiscard]] double fraction() const noexcept { return fraction_; }

  private:
    static constexpr std::int64_t kNotYet = -1;

    ForceGateLimits limits_;
    std::uint64_t last_ticks_ = 0;
    std::int64_t last_order_ns_ = 0;
    std::int64_t ramp_since_ns_ = kNotYet;
    double fraction_ = 0.0;
};

}  // namespace onggi::haptics::hid

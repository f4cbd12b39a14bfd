#include "engine/haptics/watchdog.h"

#include <algorithm>

#include "engine/jobs/thread_setup.h"

namespace onggi::haptics {
namespace {

constexpr std::int64_t kLookEveryNs = 1'000'000;
// Lower than the haptic loop's priority, so that the watchdog never delays it.
constexpr int kFifoPriority = 40;

}  // namespace

Watchdog::Watchdog(HapticDevice& device, const WatchdogOptions& options)
    : device_(device),
      loop_silence_ns_(std::max(options.loop_silence_ns,
                                static_cast<std::int64_t>(options.least_periods * 1e9 / options.rate_hz))),
      picture_silence_ns_(options.picture_silence_ns) {}

bool Watchdog::Watched::stands_still(std::uint64_t count, std::int64_t now_ns, std::int64_t for_ns) noexcept {
    if (count == last) return count != 0 && now_ns - since_ns > for_ns;
    last = count;
    since_ns = now_ns;
    return false;
}

std::int64_t Watchdog::round(std::int64_t now_ns) noexcept {
    if (!has_asked_for_time_) {
        has_asked_for_time_ = true;
        // Most systems refuse it; the thread then has normal priority.
        static_cast<void>(jobs::ask_for_fifo(kFifoPriority));
    }
    picture_stands_still_.store(
        picture_.stands_still(pictures_.load(std::memory_order_relaxed), now_ns, picture_silence_ns_),
        std::memory_order_relaxed);
    const bool was_silent = is_silent_;
    const bool rests = rests_.load(std::memory_order_relaxed);
    is_silent_ = loop_.stands_still(beats_.load(std::memory_order_relaxed), now_ns,
                                    loop_silence_ns_ + (rests ? 2 * kLookAtRestNs : 0));
    if (is_silent_) {
        // Count first: a loop that wakes up in between must not assume that its old force is still applied.
        if (!was_silent)
            silences_.store(silences_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
        device_.silence();
    }
    return rests ? kLookAtRestNs : kLookEveryNs;
}

}  // namespace onggi::haptics

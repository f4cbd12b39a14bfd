// The monotonic clock that the pacer uses. Tests pass a virtual one instead. Any thread; ns. A clock read is
// about 25 ns (vDSO, no system call); the sleep is a system call.
#pragma once

#include <cerrno>
#include <ctime>

#include <concepts>
#include <cstdint>

namespace onggi::jobs {

// The interface of a clock for the pacer. relax() is called in each iteration of a spin wait.
template <typename T>
concept PacerClock = requires(T clock, std::int64_t time_ns) {
    { clock.now_ns() }
    noexcept->std::same_as<std::int64_t>;
    { clock.sleep_until_ns(time_ns) }
    noexcept;
    { clock.relax() }
    noexcept;
};

inline constexpr std::int64_t kNsPerSecond = 1'000'000'000;

class MonotonicClock {
  public:
    [[nodiscard]] static std::int64_t now_ns() noexcept {
        timespec now{};
        clock_gettime(CLOCK_MONOTONIC, &now);
        return std::int64_t{now.tv_sec} * kNsPerSecond + now.tv_nsec;
    }
    [[nodiscard]] static double now_s() noexcept {
        return static_cast<double>(now_ns()) / static_cast<double>(kNsPerSecond);
    }

    // Returns no earlier than time_ns: a signal does not end the wait.
    static void sleep_until_ns(std::int64_t time_ns) noexcept {
        const timespec until{.tv_sec = time_ns / kNsPerSecond, .tv_nsec = time_ns % kNsPerSecond};
        while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
        }
    }

    static void relax() noexcept {
#if defined(__x86_64__) || defined(__i386__)
        __builtin_ia32_pause();
#elif defined(__aarch64__)
        asm volatile("yield");
#endif
    }
};

// The processor time of the calling thread, ns; it excludes waits, so a difference is the cost of the work
// between.
class ThreadClock {
  public:
    [[nodiscard]] static std::int64_t now_ns() noexcept {
        timespec now{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
        return std::int64_t{now.tv_sec} * kNsPerSecond + now.tv_nsec;
    }
};

}  // namespace onggi::jobs

// A thread for blocking work, such as a device or a socket. It calls round() repeatedly; each call returns
// the time to sleep before the next. Times are ns of the monotonic clock.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

#include "engine/core/result.h"

namespace onggi::jobs {

class IoWork {
  public:
    virtual ~IoWork() = default;

    // The I/O thread. May block for at most tens of ms, because stop() waits for the round to end. Returns
    // how long to sleep before the next round; 0: no sleep.
    [[nodiscard]] virtual std::int64_t round(std::int64_t now_ns) noexcept = 0;
    // The I/O thread, once, after the last round: clean up, such as by stopping a device.
    virtual void finish() noexcept = 0;
};

// Every method belongs to the one thread that owns the object.
class IoThread {
  public:
    IoThread() = default;
    ~IoThread() { stop(); }
    IoThread(const IoThread&) = delete;
    IoThread& operator=(const IoThread&) = delete;

    // `work` must outlive the run; `name` has at most 15 letters. The thread has normal priority and inherits
    // the caller's cores. Error: kFailed if the thread cannot start. Precondition: not running.
    Result<void> start(IoWork& work, const std::string& name);
    // Interrupts the sleep, waits for the round and finish(), and joins. Does nothing if it is not running.
    void stop() noexcept;
    // Any thread: ends the sleep, or the next one. Takes a lock that the I/O thread holds for an instant.
    void wake() noexcept;
    [[nodiscard]] bool running() const noexcept { return thread_.joinable(); }

  private:
    void run(IoWork& work) noexcept;

    std::mutex mutex_;
    std::condition_variable changed_;
    bool stop_ = false;   // under mutex_
    bool awake_ = false;  // likewise
    std::thread thread_;
};

// A lock for libraries that allow one caller at a time, shared by I/O threads. Never used by the tick.
using Turnstile = std::mutex;
using TurnstilePass = std::lock_guard<Turnstile>;

}  // namespace onggi::jobs

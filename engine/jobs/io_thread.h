// A thread that waits for something slow - a device, a socket - so that nobody else has to. Its work does one
// round after the other and says how long it may rest between them. Times are ns of the monotonic clock.
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

    // The I/O thread. May block, but for tens of ms at most: stop() waits for the round to end. Returns how
    // long to rest before the next, 0: not at all.
    [[nodiscard]] virtual std::int64_t round(std::int64_t now_ns) noexcept = 0;
    // The I/O thread, once, after the last round: the place to leave a device in peace.
    virtual void finish() noexcept = 0;
};

// Every method belongs to the one thread that owns the object.
class IoThread {
  public:
    IoThread() = default;
    ~IoThread() { stop(); }
    IoThread(const IoThread&) = delete;
    IoThread& operator=(const IoThread&) = delete;

    // `work` must outlive the run; `name` has at most 15 letters. The thread is an ordinary one and inherits
    // the caller's cores. Error: kFailed when no thread can be made. Precondition: not running.
    Result<void> start(IoWork& work, const std::string& name);
    // Ends any rest at once, waits for the round and for finish(), joins. Harmless when it does not run.
    void stop() noexcept;
    [[nodiscard]] bool running() const noexcept { return thread_.joinable(); }

  private:
    void run(IoWork& work) noexcept;

    std::mutex mutex_;
    std::condition_variable stop_asked_;
    bool stop_ = false;  // under mutex_
    std::thread thread_;
};

// A lock for libraries that bear one caller at a time, shared by I/O threads. Never near the tick.
using Turnstile = std::mutex;
using TurnstilePass = std::lock_guard<Turnstile>;

}  // namespace onggi::jobs

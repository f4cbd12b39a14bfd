#include "engine/jobs/io_thread.h"

#include <cassert>
#include <chrono>
#include <system_error>

#include "engine/jobs/clock.h"
#include "engine/jobs/thread_setup.h"

namespace onggi::jobs {

Result<void> IoThread::start(IoWork& work, const std::string& name) {
    assert(!thread_.joinable());
    stop_ = false;
    try {
        thread_ = std::thread([this, &work, name] {
            name_this_thread(name.c_str());
            run(work);
        });
    } catch (const std::system_error& error) {
        return failed("cannot start the thread " + name + ": " + error.what());
    }
    return {};
}

void IoThread::stop() noexcept {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    changed_.notify_one();
    thread_.join();
}

void IoThread::wake() noexcept {
    {
        const std::lock_guard lock(mutex_);
        awake_ = true;
    }
    changed_.notify_one();
}

void IoThread::run(IoWork& work) noexcept {
    std::unique_lock lock(mutex_);
    while (!stop_) {
        lock.unlock();
        const std::int64_t rest_ns = work.round(MonotonicClock::now_ns());
        lock.lock();
        if (rest_ns > 0)
            changed_.wait_for(lock, std::chrono::nanoseconds(rest_ns), [this] { return stop_ || awake_; });
        awake_ = false;
    }
    lock.unlock();
    work.finish();
}

}  // namespace onggi::jobs

#include "engine/jobs/shared_loop.h"

#include <system_error>

namespace onggi::jobs {

Result<void> SharedLoop::start(std::span<const int> cores, const std::string& name) {
    if (cores.empty() || is_shared()) return {};
    try {
        thread_ = std::thread([this, name, own = std::vector<int>(cores.begin(), cores.end())] {
            name_this_thread(name.c_str());
            static_cast<void>(keep_this_thread_on(own));
            help();
        });
    } catch (const std::system_error& error) {
        return failed("cannot start the thread " + name + ": " + error.what());
    }
    return {};
}

void SharedLoop::stop() noexcept {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        stops_ = true;
    }
    begun_.notify_one();
    thread_.join();
    stops_ = false;
}

void SharedLoop::share(const Loop& loop) {
    {
        const std::lock_guard lock(mutex_);
        loop_ = loop;
        ++round_;
        next_ = 0;
    }
    begun_.notify_one();
    take_pieces(loop);
    // A second thread that has not woken up by now finds no loop open.
    std::unique_lock lock(mutex_);
    loop_ = {};
    left_.wait(lock, [this] { return !is_inside_; });
}

void SharedLoop::take_pieces(const Loop& loop) {
    for (int number = next_++; number < loop.count; number = next_++)
        loop.call(loop.called, number);
}

void SharedLoop::help() {
    std::uint64_t seen = 0;
    std::unique_lock lock(mutex_);
    while (true) {
        begun_.wait(lock, [&] { return stops_ || (loop_.count > 0 && round_ != seen); });
        if (stops_) return;
        seen = round_;
        is_inside_ = true;
        const Loop loop = loop_;
        lock.unlock();
        take_pieces(loop);
        lock.lock();
        is_inside_ = false;
        left_.notify_one();
    }
}

std::vector<int> cores_of_second_thread(const CoreChoice& choice, bool is_real_time) {
    if (choice.others.size() > 1) return choice.others;
    if (choice.shared() || !is_real_time) return {};
    return {choice.core};
}

}  // namespace onggi::jobs

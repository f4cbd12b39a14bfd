// A loop over independent pieces of work that a second thread shares with its caller: both take the next
// piece until none is left. The second thread sleeps between loops.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/core/result.h"
#include "engine/jobs/thread_setup.h"

namespace onggi::jobs {

// Every method belongs to the one thread that owns the object.
class SharedLoop {
  public:
    SharedLoop() = default;
    ~SharedLoop() { stop(); }
    SharedLoop(const SharedLoop&) = delete;
    SharedLoop& operator=(const SharedLoop&) = delete;

    // Starts the second thread, with normal priority, on these cores; does nothing if `cores` is empty or the
    // thread runs. Error: kFailed if the thread cannot start. `name`: see name_this_thread().
    Result<void> start(std::span<const int> cores, const std::string& name);
    // Ends the second thread: run() then works alone.
    void stop() noexcept;
    [[nodiscard]] bool is_shared() const noexcept { return thread_.joinable(); }

    // Calls piece(0) to piece(count - 1) once each, in any order and on either thread, and returns when all
    // have returned. Pieces must not throw. Without a second thread they run in order.
    template <typename Piece>
    void run(int count, Piece&& piece) {
        using Called = std::remove_reference_t<Piece>;
        const Loop loop{.count = count, .called = &piece, .call = [](const void* called, int number) {
                            (*static_cast<const Called*>(called))(number);
                        }};
        if (is_shared() && count > 1) return share(loop);
        for (int number = 0; number < count; ++number)
            piece(number);
    }

  private:
    struct Loop {
        int count = 0;
        const void* called = nullptr;
        void (*call)(const void* called, int number) = nullptr;
    };
    void share(const Loop& loop);
    void take_pieces(const Loop& loop);
    void help();

    std::mutex mutex_;
    std::condition_variable begun_;
    std::condition_variable left_;
    Loop loop_;                // under mutex_, like all up to `stops_`; without pieces: no loop is open
    std::uint64_t round_ = 0;  // loops begun
    bool is_inside_ = false;   // the second thread may still be in the loop
    bool stops_ = false;
    std::atomic<int> next_ = 0;
    std::thread thread_;
};

// The cores of a second drawing thread: those that the haptic thread leaves free, if there are several. Else
// the haptic thread's own core, where that thread has real-time priority and so interrupts the drawing at
// once; without that priority (`is_real_time`), none.
[[nodiscard]] std::vector<int> cores_of_second_thread(const CoreChoice& choice, bool is_real_time);

}  // namespace onggi::jobs

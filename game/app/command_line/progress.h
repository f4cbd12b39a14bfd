// Shows the progress of long work on a terminal, and nothing in a pipe or a file. Main thread.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace onggi::app {

// One line on stderr, rewritten a few times a second and erased at the end. Plain text without colours.
class Progress {
  public:
    Progress(std::string doing, std::uint64_t of);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress();

    // Cheap enough for every tick: reads the clock once in a thousand calls.
    void reached(std::uint64_t done) {
        if (shown_ && ++calls_ % 1024 == 0) show(done);
    }

    // The same for rare calls, such as frames: reads the clock each time.
    void reached_rarely(std::uint64_t done) {
        if (shown_) show(done);
    }

  private:
    void show(std::uint64_t done);

    std::string doing_;
    std::uint64_t of_;
    bool shown_;
    std::uint64_t calls_ = 0;
    std::size_t width_ = 0;  // of the printed line
    std::chrono::steady_clock::time_point last_;
};

}  // namespace onggi::app

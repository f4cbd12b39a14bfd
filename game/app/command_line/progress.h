// How far long work has come, on a terminal; in a pipe or a file, nothing. Main thread.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace onggi::app {

// One line on stderr that is rewritten a few times a second and gone at the end. Plain text: no colours.
class Progress {
  public:
    Progress(std::string doing, std::uint64_t of);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress();

    // Cheap enough for every tick: looks at the clock once in a thousand calls.
    void reached(std::uint64_t done) {
        if (shown_ && ++calls_ % 1024 == 0) show(done);
    }

    // The same for calls that are rare, such as frames: looks at the clock each time.
    void reached_rarely(std::uint64_t done) {
        if (shown_) show(done);
    }

  private:
    void show(std::uint64_t done);

    std::string doing_;
    std::uint64_t of_;
    bool shown_;
    std::uint64_t calls_ = 0;
    std::size_t width_ = 0;  // of what stands on the line
    std::chrono::steady_clock::time_point last_;
};

}  // namespace onggi::app

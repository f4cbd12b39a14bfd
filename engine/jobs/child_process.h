// Runs another program beside this one, with low priority, so that it delays neither ticks nor frames. It
// shares this program's standard error, and inherits nothing else. One thread at a time; only waiting for a
// killed process blocks, and read(), as long as it is told to.
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/core/result.h"

namespace onggi::jobs {

class ChildProcess {
  public:
    enum class Kind {
        kIdle,     // runs while nothing else does (SCHED_IDLE); what it writes is dropped
        kAnswers,  // somebody waits for its standard output: nice 10
    };

    // The first word is the program: a path, or a name that is looked up in PATH. Error: system lacks, if
    // there is no such program or no process can be made.
    [[nodiscard]] static Result<ChildProcess> start(std::vector<std::string> words, Kind kind = Kind::kIdle);
    ChildProcess(ChildProcess&& other) noexcept { swap(other); }
    ChildProcess& operator=(ChildProcess&& other) noexcept {
        swap(other);
        return *this;
    }
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;
    // Kills the process if it still runs.
    ~ChildProcess();

    // Sends one line and closes its input. Ignores errors: the process may have ended.
    void tell(std::string_view line);
    // Appends what a process that answers has written since, after waiting for it for up to `wait_ms`.
    // Returns false at its end.
    [[nodiscard]] bool read(std::string& answer, int wait_ms);
    [[nodiscard]] bool is_at_work();
    // It has ended with exit code 0.
    [[nodiscard]] bool has_succeeded() const { return has_succeeded_; }

  private:
    ChildProcess() = default;
    void swap(ChildProcess& other) noexcept {
        std::swap(process_, other.process_);
        std::swap(socket_, other.socket_);
        std::swap(has_succeeded_, other.has_succeeded_);
    }
    void hang_up() noexcept;

    pid_t process_ = 0;  // 0: it has ended
    int socket_ = -1;    // its standard input, and its output if it answers
    bool has_succeeded_ = false;
};

}  // namespace onggi::jobs

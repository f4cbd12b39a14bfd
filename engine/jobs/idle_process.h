// Runs another program with idle priority (SCHED_IDLE), so that it delays neither ticks nor frames. It reads
// lines from its standard input, shares this program's standard error, and inherits nothing else. One thread
// at a time; only waiting for a killed process blocks.
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/core/result.h"

namespace onggi::jobs {

class IdleProcess {
  public:
    // The first word is the program's path. Error: system lacks, if there is no such program or no process
    // can be made.
    [[nodiscard]] static Result<IdleProcess> start(std::vector<std::string> words);
    IdleProcess(IdleProcess&& other) noexcept { swap(other); }
    IdleProcess& operator=(IdleProcess&& other) noexcept {
        swap(other);
        return *this;
    }
    IdleProcess(const IdleProcess&) = delete;
    IdleProcess& operator=(const IdleProcess&) = delete;
    // Kills the process if it still runs.
    ~IdleProcess();

    // Sends one line and closes its input. Ignores errors: the process may have ended.
    void tell(std::string_view line);
    [[nodiscard]] bool is_at_work();
    // It has ended with exit code 0.
    [[nodiscard]] bool has_succeeded() const { return has_succeeded_; }

  private:
    IdleProcess() = default;
    void swap(IdleProcess& other) noexcept {
        std::swap(process_, other.process_);
        std::swap(input_, other.input_);
        std::swap(has_succeeded_, other.has_succeeded_);
    }
    void end_of_input() noexcept;

    pid_t process_ = 0;  // 0: it has ended
    int input_ = -1;
    bool has_succeeded_ = false;
};

}  // namespace onggi::jobs

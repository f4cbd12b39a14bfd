// A program at work beside this one, which gets only what nobody else wants of the processor (SCHED_IDLE), so
// that neither a tick nor a picture waits for it. It hears what it is told on its standard input, says its
// errors where this program says its own, and inherits nothing else. One thread at a time; nothing blocks but
// the end of a process that was killed.
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
    // The first of the words is the program's path. System lacks: no such program, no process.
    [[nodiscard]] static Result<IdleProcess> start(std::vector<std::string> words);
    IdleProcess(IdleProcess&& other) noexcept { swap(other); }
    IdleProcess& operator=(IdleProcess&& other) noexcept {
        swap(other);
        return *this;
    }
    IdleProcess(const IdleProcess&) = delete;
    IdleProcess& operator=(const IdleProcess&) = delete;
    // Whoever is still at work is killed.
    ~IdleProcess();

    // The last that it is told. Whether it still listens does not matter.
    void tell(std::string_view line);
    [[nodiscard]] bool is_at_work();
    // It has ended, and says that all went well.
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

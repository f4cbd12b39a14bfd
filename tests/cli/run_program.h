// Runs the built program and looks at what a caller sees: exit code, output, errors, memory.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace onggi::test {

struct ProgramRun {
    int exit_code = -1;  // -1: it did not exit by itself
    std::string out;
    std::string err;
    long most_memory_kb = 0;
};

struct ProgramOptions {
    std::string folder = ".";                   // to run in
    std::vector<std::string> environment = {};  // NAME=VALUE, on top of the test's own
    std::function<void()> in_child = [] {};     // just before the program takes the process over
};

// `onggi` with these words; its output goes into pipes.
ProgramRun run_onggi(const std::vector<std::string>& words, const ProgramOptions& options = {});

// The same on a terminal: all it prints is in `out`.
ProgramRun run_onggi_on_terminal(const std::vector<std::string>& words, const ProgramOptions& options = {});

// Starts it, and kills it after so many milliseconds. True if it was still at work.
bool run_onggi_and_kill(const std::vector<std::string>& words, int after_ms,
                        const ProgramOptions& options = {});

// The program at work, while the test goes on. Killed when it goes out of scope.
class RunningOnggi {
  public:
    explicit RunningOnggi(const std::vector<std::string>& words, const ProgramOptions& options = {});
    ~RunningOnggi();
    RunningOnggi(const RunningOnggi&) = delete;
    RunningOnggi& operator=(const RunningOnggi&) = delete;

    // What it has printed so far, output and errors together.
    [[nodiscard]] const std::string& printed();
    [[nodiscard]] bool at_work();
    void signal(int number) const;
    [[nodiscard]] int process() const { return child_; }
    // Waits for it to end by itself, at most so long (comes_true.h). -1: it did not, or a signal ended it.
    int exit_code(std::chrono::seconds most = std::chrono::seconds(60));

  private:
    int child_ = -1;
    int pipe_ = -1;
    bool has_ended_ = false;
    int status_ = 0;
    std::string printed_;
};

// Whether the program is built with a sanitizer, which needs memory of its own.
constexpr bool is_sanitized() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    return true;
#else
    return false;
#endif
}

}  // namespace onggi::test

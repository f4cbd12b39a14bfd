// Runs the built program and captures exit code, output, errors and memory.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace onggi::test {

struct ProgramRun {
    int exit_code = -1;  // -1: a signal ended it
    std::string out;
    std::string err;
    long most_memory_kb = 0;
};

struct ProgramOptions {
    std::string folder = ".";                   // to run in
    std::vector<std::string> environment = {};  // NAME=VALUE, on top of the test's own
    std::function<void()> in_child = [] {};     // in the child, just before exec
};

// Runs `onggi` with these arguments; its output goes into pipes. ONGGI_INSTALLED: that program instead of
// this build's.
ProgramRun run_onggi(const std::vector<std::string>& words, const ProgramOptions& options = {});

// The same on a terminal: `out` holds all output.
ProgramRun run_onggi_on_terminal(const std::vector<std::string>& words, const ProgramOptions& options = {});

// Starts `onggi`, and kills it after after_ms. Returns whether it was still running.
bool run_onggi_and_kill(const std::vector<std::string>& words, int after_ms,
                        const ProgramOptions& options = {});

// A running program. Killed at the end of the scope.
class RunningOnggi {
  public:
    explicit RunningOnggi(const std::vector<std::string>& words, const ProgramOptions& options = {});
    ~RunningOnggi();
    RunningOnggi(const RunningOnggi&) = delete;
    RunningOnggi& operator=(const RunningOnggi&) = delete;

    // Its output and errors so far, together.
    [[nodiscard]] const std::string& printed();
    [[nodiscard]] bool at_work();
    void signal(int number) const;
    [[nodiscard]] int process() const { return child_; }
    // Waits at most that long (comes_true.h) for the program to end. Returns -1 after a timeout or if a
    // signal ended it.
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

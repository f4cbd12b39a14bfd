#include "tests/cli/run_program.h"
#include "tests/support/comes_true.h"
#include "tests/support/places.h"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>  // NOLINT: kill is POSIX
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <stdexcept>

namespace onggi::test {
namespace {

[[noreturn]] void become_onggi(const std::vector<std::string>& words, const ProgramOptions& options) {
    const char* const installed = std::getenv("ONGGI_INSTALLED");
    const std::string program = installed != nullptr ? installed : in_build("onggi");
    std::vector<char*> arguments{const_cast<char*>("onggi")};  // NOLINT: execv takes char*, writes nothing
    for (const std::string& word : words)
        arguments.push_back(const_cast<char*>(word.c_str()));  // NOLINT
    arguments.push_back(nullptr);
    std::vector<std::string> environment = options.environment;
    for (std::string& variable : environment)
        ::putenv(variable.data());
    if (::chdir(options.folder.c_str()) == 0) {
        options.in_child();
        ::execv(program.c_str(), arguments.data());
    }
    ::_exit(127);
}

// Appends the available output; false at the end of the output.
bool read_some(int descriptor, std::string& text) {
    std::array<char, 65536> bytes{};
    const ssize_t got = ::read(descriptor, bytes.data(), bytes.size());
    if (got <= 0) return false;  // a terminal's end is an error, EIO
    text.append(bytes.data(), static_cast<std::size_t>(got));
    return true;
}

void wait_for(pid_t child, ProgramRun& run) {
    int status = 0;
    struct rusage usage {};
    ::wait4(child, &status, 0, &usage);
    if (WIFEXITED(status)) run.exit_code = WEXITSTATUS(status);
    run.most_memory_kb = usage.ru_maxrss;
}

}  // namespace

ProgramRun run_onggi(const std::vector<std::string>& words, const ProgramOptions& options) {
    std::array<int, 2> out{};
    std::array<int, 2> err{};
    if (::pipe(out.data()) != 0 || ::pipe(err.data()) != 0) throw std::runtime_error("no pipes");
    const pid_t child = ::fork();
    if (child == 0) {
        ::dup2(out[1], STDOUT_FILENO);
        ::dup2(err[1], STDERR_FILENO);
        for (const int descriptor : {out[0], out[1], err[0], err[1]})
            ::close(descriptor);
        become_onggi(words, options);
    }
    ::close(out[1]);
    ::close(err[1]);
    ProgramRun run;
    std::array<pollfd, 2> open{{{out[0], POLLIN, 0}, {err[0], POLLIN, 0}}};
    while (open[0].fd >= 0 || open[1].fd >= 0) {
        ::poll(open.data(), open.size(), -1);
        if (open[0].revents != 0 && !read_some(open[0].fd, run.out)) open[0].fd = -1;
        if (open[1].revents != 0 && !read_some(open[1].fd, run.err)) open[1].fd = -1;
    }
    ::close(out[0]);
    ::close(err[0]);
    wait_for(child, run);
    return run;
}

ProgramRun run_onggi_on_terminal(const std::vector<std::string>& words, const ProgramOptions& options) {
    int terminal = -1;
    const pid_t child = ::forkpty(&terminal, nullptr, nullptr, nullptr);
    if (child == 0) become_onggi(words, options);
    ProgramRun run;
    while (read_some(terminal, run.out)) {
    }
    ::close(terminal);
    wait_for(child, run);
    return run;
}

bool run_onggi_and_kill(const std::vector<std::string>& words, int after_ms, const ProgramOptions& options) {
    const pid_t child = ::fork();
    if (child == 0) become_onggi(words, options);
    ::poll(nullptr, 0, after_ms);
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFSIGNALED(status);
}

RunningOnggi::RunningOnggi(const std::vector<std::string>& words, const ProgramOptions& options) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
    child_ = ::fork();
    if (child_ == 0) {
        ::dup2(ends[1], STDOUT_FILENO);
        ::dup2(ends[1], STDERR_FILENO);
        ::close(ends[0]);
        ::close(ends[1]);
        become_onggi(words, options);
    }
    ::close(ends[1]);
    pipe_ = ends[0];
    ::fcntl(pipe_, F_SETFL, O_NONBLOCK);
}

RunningOnggi::~RunningOnggi() {
    if (at_work()) {
        ::kill(child_, SIGKILL);
        ::waitpid(child_, &status_, 0);
    }
    ::close(pipe_);
}

const std::string& RunningOnggi::printed() {
    while (read_some(pipe_, printed_)) {
    }
    return printed_;
}

bool RunningOnggi::at_work() {
    if (!has_ended_) has_ended_ = ::waitpid(child_, &status_, WNOHANG) == child_;
    return !has_ended_;
}

void RunningOnggi::signal(int number) const {
    ::kill(child_, number);
}

int RunningOnggi::exit_code(std::chrono::seconds most) {
    const bool has_ended = comes_true(
        [&] {
            (void)printed();  // a full pipe would block it
            return !at_work();
        },
        most);
    return has_ended && WIFEXITED(status_) ? WEXITSTATUS(status_) : -1;
}

}  // namespace onggi::test

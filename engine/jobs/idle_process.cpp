#include "engine/jobs/idle_process.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <sched.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace onggi::jobs {
namespace {

// The descriptors and signal mask of the new process.
class Beginning {
  public:
    explicit Beginning(int input) {
        ::posix_spawn_file_actions_init(&actions_);
        ::posix_spawn_file_actions_adddup2(&actions_, input, STDIN_FILENO);
        ::posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        ::posix_spawn_file_actions_addclosefrom_np(&actions_, STDERR_FILENO + 1);
        ::posix_spawnattr_init(&attributes_);
        // This program's threads may block signals; the child must receive them, so that it can be ended.
        sigset_t none;
        ::sigemptyset(&none);
        ::posix_spawnattr_setsigmask(&attributes_, &none);
        ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK);
    }
    ~Beginning() {
        ::posix_spawnattr_destroy(&attributes_);
        ::posix_spawn_file_actions_destroy(&actions_);
    }
    Beginning(const Beginning&) = delete;
    Beginning& operator=(const Beginning&) = delete;

    // Returns 0 or an errno.
    [[nodiscard]] int run(std::vector<std::string>& words, pid_t& process) const {
        std::vector<char*> pointers;
        for (std::string& word : words)
            pointers.push_back(word.data());
        pointers.push_back(nullptr);
        return ::posix_spawn(&process, words.front().c_str(), &actions_, &attributes_, pointers.data(),
                             environ);
    }

  private:
    posix_spawn_file_actions_t actions_{};
    posix_spawnattr_t attributes_{};
};

}  // namespace

Result<IdleProcess> IdleProcess::start(std::vector<std::string> words) {
    // A socket, not a pipe: writing without a reader then raises no SIGPIPE.
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
        return system_lacks(fmt::format("{}: {}", words.front(), std::strerror(errno)));
    IdleProcess started;
    started.input_ = ends[0];
    pid_t process = 0;
    const int lack = Beginning(ends[1]).run(words, process);
    ::close(ends[1]);
    if (lack != 0) return system_lacks(fmt::format("{}: {}", words.front(), std::strerror(lack)));
    started.process_ = process;
    // Set here, because glibc's posix_spawnattr_setschedpolicy() refuses SCHED_IDLE.
    const sched_param no_priority{};
    ::sched_setscheduler(process, SCHED_IDLE, &no_priority);
    return started;
}

IdleProcess::~IdleProcess() {
    if (process_ != 0) {
        ::kill(process_, SIGKILL);
        ::waitpid(process_, nullptr, 0);
    }
    end_of_input();
}

void IdleProcess::tell(std::string_view line) {
    if (input_ < 0) return;
    const std::string whole = std::string(line) + '\n';
    static_cast<void>(::send(input_, whole.data(), whole.size(), MSG_NOSIGNAL));
    end_of_input();
}

bool IdleProcess::is_at_work() {
    if (process_ == 0) return false;
    int status = 0;
    if (::waitpid(process_, &status, WNOHANG) == 0) return true;
    process_ = 0;
    end_of_input();
    has_succeeded_ = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    return false;
}

void IdleProcess::end_of_input() noexcept {
    if (input_ >= 0) ::close(input_);
    input_ = -1;
}

}  // namespace onggi::jobs

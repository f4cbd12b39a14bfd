#include "engine/jobs/child_process.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <spawn.h>
#include <sys/resource.h>
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
    Beginning(int socket, ChildProcess::Kind kind) {
        ::posix_spawn_file_actions_init(&actions_);
        ::posix_spawn_file_actions_adddup2(&actions_, socket, STDIN_FILENO);
        if (kind == ChildProcess::Kind::kAnswers) {
            ::posix_spawn_file_actions_adddup2(&actions_, socket, STDOUT_FILENO);
        } else {
            ::posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        }
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
        return ::posix_spawnp(&process, words.front().c_str(), &actions_, &attributes_, pointers.data(),
                              environ);
    }

  private:
    posix_spawn_file_actions_t actions_{};
    posix_spawnattr_t attributes_{};
};

}  // namespace

Result<ChildProcess> ChildProcess::start(std::vector<std::string> words, Kind kind) {
    // A socket, not a pipe: writing without a reader then raises no SIGPIPE, and one serves both directions.
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
        return system_lacks(fmt::format("{}: {}", words.front(), std::strerror(errno)));
    ChildProcess started;
    started.socket_ = ends[0];
    pid_t process = 0;
    const int lack = Beginning(ends[1], kind).run(words, process);
    ::close(ends[1]);
    if (lack != 0) return system_lacks(fmt::format("{}: {}", words.front(), std::strerror(lack)));
    started.process_ = process;
    if (kind == Kind::kAnswers) {
        constexpr int kNice = 10;
        ::setpriority(PRIO_PROCESS, static_cast<id_t>(process), kNice);
        return started;
    }
    // Set here, because glibc's posix_spawnattr_setschedpolicy() refuses SCHED_IDLE.
    const sched_param no_priority{};
    ::sched_setscheduler(process, SCHED_IDLE, &no_priority);
    return started;
}

ChildProcess::~ChildProcess() {
    if (process_ != 0) {
        ::kill(process_, SIGKILL);
        ::waitpid(process_, nullptr, 0);
    }
    hang_up();
}

void ChildProcess::tell(std::string_view line) {
    if (socket_ < 0) return;
    const std::string whole = std::string(line) + '\n';
    // A process that does not read must not hold this one.
    static_cast<void>(::send(socket_, whole.data(), whole.size(), MSG_NOSIGNAL | MSG_DONTWAIT));
    ::shutdown(socket_, SHUT_WR);
}

bool ChildProcess::read(std::string& answer, int wait_ms) {
    if (socket_ < 0) return false;
    pollfd wait{.fd = socket_, .events = POLLIN, .revents = 0};
    if (::poll(&wait, 1, wait_ms) <= 0) return true;
    std::array<char, 16384> part{};
    const ssize_t size = ::recv(socket_, part.data(), part.size(), MSG_DONTWAIT);
    if (size < 0) return errno == EAGAIN || errno == EINTR;
    answer.append(part.data(), static_cast<std::size_t>(size));
    return size > 0;
}

bool ChildProcess::is_at_work() {
    if (process_ == 0) return false;
    int status = 0;
    if (::waitpid(process_, &status, WNOHANG) == 0) return true;
    process_ = 0;
    has_succeeded_ = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    return false;
}

void ChildProcess::hang_up() noexcept {
    if (socket_ >= 0) ::close(socket_);
    socket_ = -1;
}

}  // namespace onggi::jobs

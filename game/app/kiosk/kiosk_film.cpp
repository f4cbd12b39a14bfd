#include "game/app/kiosk/kiosk_film.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <sched.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstring>
#include <string>
#include <system_error>
#include <vector>

namespace onggi::app {
namespace {

void close_if_open(int& descriptor) {
    if (descriptor >= 0) ::close(descriptor);
    descriptor = -1;
}

// Attributes and actions of a process that gets only what nobody else wants of the processor, hears `input`
// and inherits no other descriptor but that of errors.
class QuietStart {
  public:
    explicit QuietStart(int input) {
        ::posix_spawn_file_actions_init(&actions_);
        ::posix_spawn_file_actions_adddup2(&actions_, input, STDIN_FILENO);
        ::posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        ::posix_spawn_file_actions_addclosefrom_np(&actions_, STDERR_FILENO + 1);
        ::posix_spawnattr_init(&attributes_);
        const sched_param no_priority{};
        ::posix_spawnattr_setschedpolicy(&attributes_, SCHED_IDLE);
        ::posix_spawnattr_setschedparam(&attributes_, &no_priority);
        // The kiosk's threads may hold signals back; who is told to end shall.
        sigset_t none;
        ::sigemptyset(&none);
        ::posix_spawnattr_setsigmask(&attributes_, &none);
        ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSCHEDULER | POSIX_SPAWN_SETSIGMASK);
    }
    ~QuietStart() {
        ::posix_spawnattr_destroy(&attributes_);
        ::posix_spawn_file_actions_destroy(&actions_);
    }
    QuietStart(const QuietStart&) = delete;
    QuietStart& operator=(const QuietStart&) = delete;

    // Its process, or the error.
    int run(std::vector<std::string>& words, pid_t& process) {
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

Result<void> KioskFilm::begin(const std::filesystem::path& session) {
    drop();
    if (program_.empty()) return {};
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    const std::filesystem::path taken = folder_ / "session.onggi";
    if (!error) std::filesystem::rename(session, taken, error);
    if (error) return system_lacks(fmt::format("film: {}: {}", taken.string(), error.message()));
    // A socket, not a pipe: to write to one whose reader is gone is no signal.
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
        return system_lacks(fmt::format("film: {}", std::strerror(errno)));
    const Files made = places();
    std::vector<std::string> words{program_,  "film",    taken,       "--out",
                                   made.film, "--still", made.still,  "--quick",
                                   "--glaze", "-",       "--seconds", fmt::format("{}", kSeconds)};
    const int lack = QuietStart(ends[1]).run(words, process_);
    ::close(ends[1]);
    glaze_ = ends[0];
    if (lack == 0) return {};
    process_ = 0;
    close_if_open(glaze_);
    return system_lacks(fmt::format("film: {}: {}", program_.string(), std::strerror(lack)));
}

void KioskFilm::finish_in(std::string_view glaze) {
    if (glaze_ < 0) return;
    const std::string line = std::string(glaze) + '\n';
    static_cast<void>(::send(glaze_, line.data(), line.size(), MSG_NOSIGNAL));
    close_if_open(glaze_);
}

bool KioskFilm::is_in_the_making() {
    if (process_ == 0) return false;
    int status = 0;
    if (::waitpid(process_, &status, WNOHANG) == 0) return true;
    process_ = 0;
    close_if_open(glaze_);
    is_made_ = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    return false;
}

std::optional<KioskFilm::Files> KioskFilm::files() const {
    return is_made_ ? std::optional(places()) : std::nullopt;
}

void KioskFilm::drop() noexcept {
    if (process_ != 0) {
        ::kill(process_, SIGKILL);
        ::waitpid(process_, nullptr, 0);
        process_ = 0;
    }
    close_if_open(glaze_);
    is_made_ = false;
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

}  // namespace onggi::app

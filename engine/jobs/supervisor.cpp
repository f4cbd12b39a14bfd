#include "engine/jobs/supervisor.h"

#include <signal.h>  // NOLINT: sigwaitinfo is POSIX
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

namespace onggi::jobs {
namespace {

constexpr int kAfterCrash = 1;

sigset_t signals_to_hand_on() {
    sigset_t set;
    sigemptyset(&set);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGABRT, SIGCHLD})
        sigaddset(&set, signal);
    return set;
}

// Waits until the child has ended. Returns its status.
int wait_for(pid_t child, const sigset_t& watched) {
    for (;;) {
        int status = 0;
        // Check first: the child may have ended before the wait for signals.
        const pid_t ended = ::waitpid(child, &status, WNOHANG);
        if (ended == child || (ended < 0 && errno != EINTR)) return status;
        siginfo_t info{};
        const int signal = ::sigwaitinfo(&watched, &info);
        // A terminal's signal reaches the whole process group; only one sent by a process was for the
        // supervisor alone.
        const bool was_sent = info.si_code == SI_USER || info.si_code == SI_QUEUE || info.si_code == SI_TKILL;
        if (signal > 0 && signal != SIGCHLD && was_sent) ::kill(child, signal);
    }
}

}  // namespace

std::optional<int> supervise(const std::function<void(int signal)>& after_crash) {
    // The parent process may ignore SIGCHLD, and execve(2) inherits that; waitpid(2) would then lose the
    // child's status, and a crash or a requested restart would look like a normal end.
    ::signal(SIGCHLD, SIG_DFL);
    const sigset_t watched = signals_to_hand_on();
    sigset_t before;
    ::sigprocmask(SIG_BLOCK, &watched, &before);
    const pid_t supervisor = ::getpid();
    const pid_t child = ::fork();
    if (child <= 0) {
        if (child == 0) {
            ::prctl(PR_SET_PDEATHSIG, SIGTERM);
            // The supervisor may have died before prctl().
            if (::getppid() != supervisor) ::raise(SIGTERM);
        }
        ::sigprocmask(SIG_SETMASK, &before, nullptr);
        return std::nullopt;
    }
    const int status = wait_for(child, watched);
    int code = kAfterCrash;
    if (WIFEXITED(status)) {
        code = WEXITSTATUS(status);
        if (code == kAfterCrash) after_crash(0);
    } else if (WIFSIGNALED(status)) {
        after_crash(WTERMSIG(status));
    }
    ::sigprocmask(SIG_SETMASK, &before, nullptr);
    return code;
}

}  // namespace onggi::jobs

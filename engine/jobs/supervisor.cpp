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

// Waits until the child has ended; gives its status.
int wait_for(pid_t child, const sigset_t& watched) {
    for (;;) {
        int status = 0;
        // First: it may have ended before anybody waited for a signal.
        const pid_t ended = ::waitpid(child, &status, WNOHANG);
        if (ended == child || (ended < 0 && errno != EINTR)) return status;
        siginfo_t info{};
        const int signal = ::sigwaitinfo(&watched, &info);
        // A terminal sends to the whole group; only what a process sent was for the supervisor alone.
        const bool was_sent = info.si_code == SI_USER || info.si_code == SI_QUEUE || info.si_code == SI_TKILL;
        if (signal > 0 && signal != SIGCHLD && was_sent) ::kill(child, signal);
    }
}

}  // namespace

std::optional<int> supervise(const std::function<void(int signal)>& after_crash) {
    // Whoever started us may ignore the ends of its children, and execve(2) hands that on: then waitpid(2)
    // forgets how a child ended, and a crash or the wish for a restart would look like an end in order.
    ::signal(SIGCHLD, SIG_DFL);
    const sigset_t watched = signals_to_hand_on();
    sigset_t before;
    ::sigprocmask(SIG_BLOCK, &watched, &before);
    const pid_t supervisor = ::getpid();
    const pid_t child = ::fork();
    if (child <= 0) {
        if (child == 0) {
            ::prctl(PR_SET_PDEATHSIG, SIGTERM);
            // It may have died before that was said.
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

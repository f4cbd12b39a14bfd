#include "game/app/system/end_signal.h"

#include <signal.h>  // NOLINT: sigaction is POSIX

#include <atomic>

namespace onggi::app {
namespace {

// A signal handler may use only such atomics.
std::atomic<bool> asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);

void note(int /*signal*/) {
    asked.store(true, std::memory_order_relaxed);
}

}  // namespace

void note_end_signals(bool locked) {
    // The parent process may have blocked these signals. The program inherits the mask and could then not be
    // ended.
    sigset_t heard;
    sigemptyset(&heard);
    for (const int signal : {SIGTERM, SIGHUP, SIGINT})
        sigaddset(&heard, signal);
    pthread_sigmask(SIG_UNBLOCK, &heard, nullptr);
    struct sigaction action {};
    action.sa_handler = &note;
    action.sa_flags = SA_RESTART;
    for (const int signal : {SIGTERM, SIGHUP})
        sigaction(signal, &action, nullptr);
    action.sa_flags |= static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    if (!locked) return;
    // A visitor's keyboard must not end a kiosk; the system's SIGTERM still does.
    action.sa_handler = SIG_IGN;
    sigaction(SIGINT, &action, nullptr);
}

bool end_was_asked() {
    return asked.load(std::memory_order_relaxed);
}

}  // namespace onggi::app

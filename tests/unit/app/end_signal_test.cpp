// Signals that end the program; each case runs in its own process, because a received signal stays recorded.
#include "game/app/system/end_signal.h"

#include <gtest/gtest.h>
#include <signal.h>  // NOLINT: sigprocmask is POSIX

#include <cstdlib>

namespace onggi::app {
namespace {

// The child's exit code: 1 if it was asked to end by this signal.
[[noreturn]] void ask(int signal, bool locked) {
    sigset_t all;
    sigfillset(&all);
    sigprocmask(SIG_SETMASK, &all, nullptr);  // as a parent process may leave it
    note_end_signals(locked);
    raise(signal);
    std::exit(end_was_asked() ? 1 : 0);
}

TEST(EndSignal, IsHeardThoughItsStarterHadBlockedAll) {
    for (const int signal : {SIGTERM, SIGHUP, SIGINT})
        EXPECT_EXIT(ask(signal, false), testing::ExitedWithCode(1), "") << signal;
}

TEST(EndSignal, OfAKeyboardEndsNoLockedKiosk) {
    EXPECT_EXIT(ask(SIGINT, true), testing::ExitedWithCode(0), "");
    EXPECT_EXIT(ask(SIGTERM, true), testing::ExitedWithCode(1), "");
}

}  // namespace
}  // namespace onggi::app

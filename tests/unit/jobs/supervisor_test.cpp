// The child of supervise() must not continue into the other tests: each ends it with _exit. A pipe reports
// its end to the test.
#include "engine/jobs/supervisor.h"

#include <gtest/gtest.h>
#include <signal.h>  // NOLINT: kill is POSIX
#include <sys/wait.h>
#include <unistd.h>

#include <array>

namespace onggi::jobs {
namespace {

struct Watched {
    int code = -1;
    int crashes = 0;
    int signal = 0;
};

template <typename Child>
Watched watch(Child&& child) {
    Watched watched;
    const auto code = supervise([&](int signal) {
        ++watched.crashes;
        watched.signal = signal;
    });
    if (!code) {
        child();
        ::_exit(99);
    }
    watched.code = *code;
    return watched;
}

TEST(Supervisor, EndsWithItsChildsOwnCode) {
    for (const int code : {0, 2, 3}) {
        const Watched watched = watch([&] { ::_exit(code); });
        EXPECT_EQ(watched.code, code);
        EXPECT_EQ(watched.crashes, 0);
    }
}

TEST(Supervisor, KnowsItsChildsStatusEvenIfSigchldWasIgnored) {
    ::signal(SIGCHLD, SIG_IGN);
    const Watched asked = watch([] { ::_exit(75); });
    ::signal(SIGCHLD, SIG_IGN);
    const Watched crashed = watch([] { ::kill(::getpid(), SIGKILL); });
    ::signal(SIGCHLD, SIG_DFL);
    EXPECT_EQ(asked.code, 75);
    EXPECT_EQ(crashed.crashes, 1);
    EXPECT_EQ(crashed.signal, SIGKILL);
}

TEST(Supervisor, CleansUpAfterAChildThatDiesOnTheSpot) {
    for (const int signal : {SIGKILL, SIGABRT}) {
        const Watched watched = watch([&] {
            ::signal(signal, SIG_DFL);
            ::kill(::getpid(), signal);
            for (;;)
                ::pause();
        });
        EXPECT_EQ(watched.code, 1);
        EXPECT_EQ(watched.crashes, 1);
        EXPECT_EQ(watched.signal, signal);
    }
}

TEST(Supervisor, CleansUpAfterALibraryThatEndedTheProgram) {
    const Watched watched = watch([] { ::_exit(1); });
    EXPECT_EQ(watched.code, 1);
    EXPECT_EQ(watched.crashes, 1);
    EXPECT_EQ(watched.signal, 0);
}

// A service manager's watchdog sends SIGABRT to everybody at once.
TEST(Supervisor, OutlivesTheWatchdogThatKillsItsChild) {
    std::array<int, 2> cleaned{};
    ASSERT_EQ(::pipe(cleaned.data()), 0);
    std::array<int, 2> ready{};
    ASSERT_EQ(::pipe(ready.data()), 0);
    const pid_t helper = ::fork();
    ASSERT_GE(helper, 0);
    if (helper == 0) {
        ::signal(SIGABRT, SIG_DFL);
        const auto code = supervise([&](int signal) {
            const char byte = signal == SIGABRT ? 'a' : '?';
            if (::write(cleaned[1], &byte, 1) != 1) ::_exit(98);
        });
        if (!code) {
            if (::write(ready[1], "x", 1) != 1) ::_exit(98);
            for (;;)
                ::pause();
        }
        ::_exit(*code);
    }
    char byte = 0;
    ASSERT_EQ(::read(ready[0], &byte, 1), 1);
    ::kill(helper, SIGABRT);
    ASSERT_EQ(::read(cleaned[0], &byte, 1), 1);
    EXPECT_EQ(byte, 'a');
    int status = 0;
    ASSERT_EQ(::waitpid(helper, &status, 0), helper);
    ASSERT_TRUE(WIFEXITED(status)) << "the supervisor was killed with its child";
    EXPECT_EQ(WEXITSTATUS(status), 1);
    for (const int end : {cleaned[0], cleaned[1], ready[0], ready[1]})
        ::close(end);
}

// A child writes a byte when it handles SIGTERM, and exits with 7 when it comes.
void hear_sigterm(int say) {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGTERM);
    ::sigprocmask(SIG_BLOCK, &set, nullptr);
    if (::write(say, "x", 1) != 1) ::_exit(98);
    int signal = 0;
    ::sigwait(&set, &signal);
    ::_exit(signal == SIGTERM ? 7 : 97);
}

TEST(Supervisor, HandsAnEndOnToItsChild) {
    std::array<int, 2> ready{};
    ASSERT_EQ(::pipe(ready.data()), 0);
    const pid_t helper = ::fork();
    ASSERT_GE(helper, 0);
    if (helper == 0) {
        // A separate supervisor, which the test can kill.
        const auto code = supervise([](int) {});
        if (!code) hear_sigterm(ready[1]);
        ::_exit(*code);
    }
    char byte = 0;
    ASSERT_EQ(::read(ready[0], &byte, 1), 1);
    ::kill(helper, SIGTERM);
    int status = 0;
    ASSERT_EQ(::waitpid(helper, &status, 0), helper);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 7);
    ::close(ready[0]);
    ::close(ready[1]);
}

TEST(Supervisor, EndsItsChildByItsOwnDeath) {
    std::array<int, 2> ready{};
    std::array<int, 2> done{};
    ASSERT_EQ(::pipe(ready.data()), 0);
    ASSERT_EQ(::pipe(done.data()), 0);
    const pid_t helper = ::fork();
    ASSERT_GE(helper, 0);
    if (helper == 0) {
        const auto code = supervise([](int) {});
        ::close(done[0]);
        if (!code) hear_sigterm(ready[1]);
        ::_exit(*code);
    }
    ::close(done[1]);
    char byte = 0;
    ASSERT_EQ(::read(ready[0], &byte, 1), 1);
    ::kill(helper, SIGKILL);
    int status = 0;
    ASSERT_EQ(::waitpid(helper, &status, 0), helper);
    // The pipe closes when the orphan has ended; otherwise the test's time limit fails it.
    EXPECT_EQ(::read(done[0], &byte, 1), 0);
    ::close(ready[0]);
    ::close(ready[1]);
    ::close(done[0]);
}

}  // namespace
}  // namespace onggi::jobs

// The report of a crash. For a crash in the middle of a visit: tests/window/looked_after.sh.
#include "game/app/system/crash_report.h"

#include <gtest/gtest.h>
#include <signal.h>  // NOLINT: SIGSEGV's handler is set by POSIX's own
#include <sys/prctl.h>

#include <new>
#include <thread>

namespace onggi::app {
namespace {

[[gnu::noinline]] void call_what_is_not_there() {
    void (*volatile nothing)() = nullptr;
    nothing();
}

TEST(CrashReport, NamesTheCallerOfAMissingFunction) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const auto crash = [] {
        ::signal(SIGSEGV, SIG_DFL);  // a sanitizer's would go first
        report_crashes();
        call_what_is_not_there();
    };
    // The caller is named by its program, and by its own name where that is exported.
    EXPECT_EXIT(crash(), testing::KilledBySignal(SIGSEGV),
                "crash: SIGSEGV at 0x0 in thread .*\n"
                ".*crash: a missing function was called from\n"
                ".*unit_app\\(.*\\) ?\\[0x[0-9a-f]+\\]\n");
}

TEST(CrashReport, SaysInOneLineThatAThreadFoundNoMemory) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const auto allocate = [] {
        report_crashes();
        std::thread([] {
            ::prctl(PR_SET_NAME, "keeper");
            throw std::bad_alloc();
        }).join();
    };
    EXPECT_EXIT(allocate(), testing::ExitedWithCode(3),
                "^(<2>)?onggi: expected memory for the thread keeper, found none left\n$");
}

TEST(CrashReport, SaysSoWhereANoexceptFunctionStopsTheExceptionAfterDestructors) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const auto allocate = [] {
        report_crashes();
        []() noexcept {
            const std::vector<int> destroyed(3);
            std::get_new_handler()();  // as operator new calls it
        }();
    };
    EXPECT_EXIT(allocate(), testing::ExitedWithCode(3),
                "^(<2>)?onggi: expected memory for the thread [a-z_]+, found none left\n$");
}

}  // namespace
}  // namespace onggi::app

// After three crashes in ten minutes the program starts in safe mode, on a virtual clock; a damaged file only
// costs one line.
#include "game/app/system/start_log.h"

#include <gtest/gtest.h>
#include <signal.h>  // NOLINT: kill is POSIX
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

constexpr std::int64_t kNow = 1'800'000'000;

TEST(StartLog, TakesAMeantEndForNoFall) {
    StartLog log;
    for (int start = 0; start < 50; ++start) {
        const StartReport report = begin(log, kNow + start);
        EXPECT_EQ(report.falls, 0);
        EXPECT_FALSE(report.is_safe_mode);
        end(log);
    }
}

TEST(StartLog, StartsInSafeModeAfterThreeFallsInTenMinutes) {
    StartLog log;
    EXPECT_FALSE(begin(log, kNow).is_safe_mode);
    EXPECT_FALSE(begin(log, kNow + 100).is_safe_mode) << "one fall";
    EXPECT_FALSE(begin(log, kNow + 300).is_safe_mode) << "two";
    const StartReport third = begin(log, kNow + 500);
    EXPECT_TRUE(third.is_safe_mode);
    EXPECT_EQ(third.falls, 3);
    EXPECT_TRUE(begin(log, kNow + 510).is_safe_mode) << "it falls there too, and stays calm";
}

TEST(StartLog, ForgetsFallsAfterTenMinutes) {
    StartLog log;
    static_cast<void>(begin(log, kNow));
    static_cast<void>(begin(log, kNow + 1));
    static_cast<void>(begin(log, kNow + 2));
    EXPECT_EQ(begin(log, kNow + 2 + kFallsCountForS).falls, 1) << "this one alone";
    EXPECT_FALSE(begin(log, kNow + 3 + kFallsCountForS).is_safe_mode);
}

TEST(StartLog, LeavesSafeModeWithTheNextStartThatIsCalm) {
    StartLog log;
    for (int fall = 0; fall < 4; ++fall)
        static_cast<void>(begin(log, kNow + fall));
    EXPECT_TRUE(begin(log, kNow + 5).is_safe_mode);
    end(log);
    EXPECT_TRUE(begin(log, kNow + 60).is_safe_mode) << "a restart alone mends nothing";
    end(log);
    EXPECT_FALSE(begin(log, kNow + 700).is_safe_mode);
}

TEST(StartLog, KeepsItsCountUnderAClockThatIsPutBack) {
    StartLog log;
    for (int fall = 0; fall < 4; ++fall)
        static_cast<void>(begin(log, kNow + 86'400 + fall));
    EXPECT_EQ(begin(log, kNow).falls, 4);
    end(log);
    EXPECT_EQ(begin(log, kNow + 599).falls, 4);
    end(log);
    EXPECT_EQ(begin(log, kNow + 600).falls, 0);
}

TEST(StartLog, HoldsNoMoreThanAFewFalls) {
    StartLog log;
    for (int fall = 0; fall < 500; ++fall)
        static_cast<void>(begin(log, kNow + fall));
    EXPECT_LE(log.falls_s.size(), 20U);
    EXPECT_LT(text_of(log).size(), 1000U);
}

TEST(StartLog, ReadsItsOwnFile) {
    const StartLog log{.is_running = true, .falls_s = {kNow, kNow + 7}};
    const auto read = read_start_log(text_of(log), "starts");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(*read, log);
}

TEST(RejectsStartLog, ThatIsBrokenInOneLine) {
    for (const std::string& text :
         {std::string(), std::string("onggi starts 1\n"), std::string("onggi starts 2\nended\n"),
          std::string("onggi starts 1\nasleep\n"), std::string("onggi starts 1\nended\nfell\n"),
          std::string("onggi starts 1\nended\nfell 12x\n"), std::string("onggi starts 1\nended\nrose 12\n"),
          std::string("onggi starts 1\nended\n\n"), std::string(300, '\0')}) {
        const auto read = read_start_log(text, "starts");
        ASSERT_FALSE(read) << text;
        EXPECT_EQ(read.error().kind, ErrorKind::kBadInput);
        EXPECT_TRUE(read.error().message.starts_with("starts, line ")) << read.error().message;
        EXPECT_EQ(read.error().message.find('\n'), std::string::npos) << read.error().message;
    }
}

TEST(StartKeeper, CountsFallsFromOneStartToTheNext) {
    const test::TemporaryFolder folder;
    for (int start = 0; start < 5; ++start) {
        std::vector<std::string> remarks;
        StartKeeper keeper(folder / "state");
        const StartReport report = keeper.begin_now(remarks);
        EXPECT_EQ(report.falls, start);
        EXPECT_EQ(report.is_safe_mode, start >= kFallsToSafeMode);
        EXPECT_EQ(remarks.size(), start == 0 ? 0U : 1U) << "one line about it";
    }
}

TEST(StartKeeper, ReportsABrokenFileInOneLineAndStartsFresh) {
    const test::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "state");
    test::put_file(folder / "state/starts", "onggi starts 1\nrunning\nfell yesterday\n");
    std::vector<std::string> remarks;
    StartKeeper keeper(folder / "state");
    EXPECT_EQ(keeper.begin_now(remarks).falls, 0);
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_NE(remarks[0].find("starts, line 3: expected 'fell' and a time"), std::string::npos) << remarks[0];
    ASSERT_TRUE(keeper.end_now());
    EXPECT_EQ(test::content_of(folder / "state/starts"), "onggi starts 1\nended\n");
}

TEST(GalleryLock, IsHeldByOneProcessUntilItEndsHoweverItEnds) {
    const test::TemporaryFolder folder;
    int ends[2] = {-1, -1};
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t first = ::fork();
    if (first == 0) {
        GalleryLock lock;
        const char answer = lock.take(folder / "state") ? 'y' : 'n';
        static_cast<void>(!::write(ends[1], &answer, 1));
        for (;;)
            ::pause();
    }
    char answer = 0;
    ASSERT_EQ(::read(ends[0], &answer, 1), 1);
    EXPECT_EQ(answer, 'y');
    {
        GalleryLock second;
        const auto refused = second.take(folder / "state");
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().kind, ErrorKind::kSystemLacks);
        EXPECT_EQ(refused.error().message, folder.path().string() +
                                               ": expected no other kiosk at this gallery, found process " +
                                               std::to_string(first));
    }
    EXPECT_EQ(GalleryLock::other_at(folder / "state"), first);
    ::kill(first, SIGKILL);
    ::waitpid(first, nullptr, 0);
    EXPECT_FALSE(GalleryLock::other_at(folder / "state"));
    GalleryLock second;
    EXPECT_TRUE(second.take(folder / "state"));
    GalleryLock nowhere;
    EXPECT_TRUE(nowhere.take("/proc/none")) << "what cannot be written cannot be mixed up";
}

TEST(StartKeeper, StartsWithoutAWritableFolder) {
    const test::TemporaryFolder folder;
    test::put_file(folder / "state", "a file where a folder is wanted");
    std::vector<std::string> remarks;
    StartKeeper keeper(folder / "state");
    EXPECT_FALSE(keeper.begin_now(remarks).is_safe_mode);
    EXPECT_EQ(remarks.size(), 1U);
}

}  // namespace
}  // namespace onggi::app

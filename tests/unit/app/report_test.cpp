// One line per event, with a priority for systemd's journal.
#include "game/app/system/report.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>

#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

TEST(Report, KnowsTheJournalByTheStreamThatSystemdNames) {
    const test::TemporaryFolder folder;
    const int before = ::dup(STDERR_FILENO);
    const int file = ::open((folder / "stream").c_str(), O_RDWR | O_CREAT, 0600);
    ASSERT_GE(::dup2(file, STDERR_FILENO), 0);
    struct stat status {};
    ASSERT_EQ(::fstat(file, &status), 0);
    ::setenv("JOURNAL_STREAM", fmt::format("{}:{}", status.st_dev, status.st_ino).c_str(), 1);
    const bool is_journal = stderr_is_journal();
    ::setenv("JOURNAL_STREAM", "1:2", 1);  // of a service whose output goes elsewhere
    const bool is_elsewhere = stderr_is_journal();
    ::unsetenv("JOURNAL_STREAM");
    const bool is_none = stderr_is_journal();
    ::dup2(before, STDERR_FILENO);
    ::close(before);
    ::close(file);
    EXPECT_TRUE(is_journal);
    EXPECT_FALSE(is_elsewhere);
    EXPECT_FALSE(is_none);
}

TEST(Report, WritesOneLinePerEventForAnyText) {
    testing::internal::CaptureStderr();
    warn("two\nlines");
    remark("one");
    EXPECT_EQ(report(bad_input("wrong")), 2);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "onggi: two lines\nonggi: one\nonggi: wrong\n");
}

}  // namespace
}  // namespace onggi::app

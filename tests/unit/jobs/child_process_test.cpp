#include "engine/jobs/child_process.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <optional>

#include "tests/support/comes_true.h"

namespace onggi::jobs {
namespace {

// Whether a shell script succeeds, with or without an input line.
bool succeeds(const std::string& script, std::optional<std::string_view> line = std::nullopt) {
    auto process = ChildProcess::start({"/bin/sh", "-c", script});
    if (!process) return false;
    if (line) process->tell(*line);
    return test::comes_true([&] { return !process->is_at_work(); }) && process->has_succeeded();
}

TEST(ChildProcess, SaysHowItEnded) {
    EXPECT_TRUE(succeeds("exit 0"));
    EXPECT_FALSE(succeeds("exit 2"));
    EXPECT_FALSE(succeeds("kill -9 $$"));
}

TEST(ChildProcess, HearsOneLineAndThenTheEnd) {
    EXPECT_TRUE(succeeds("read line && [ \"$line\" = celadon ] && ! read line", "celadon"));
    EXPECT_FALSE(succeeds("read line && [ \"$line\" = celadon ]", "iron"));
}

TEST(ChildProcess, HasIdlePriorityAndNoDescriptors) {
    // It waits for a line, so that it does not check before the policy is set.
    constexpr const char* kPolicy =
        "read line; [ \"$(cut -d' ' -f41 /proc/self/stat)\" = 5 ]";  // SCHED_IDLE, proc(5)
    EXPECT_TRUE(succeeds(kPolicy, "now"));
    const std::ifstream open("/dev/null");
    const auto other = ChildProcess::start({"/bin/sh", "-c", "read line"});
    ASSERT_TRUE(other);
    EXPECT_TRUE(succeeds("! [ -e /proc/$$/fd/3 ] && ! [ -e /proc/$$/fd/4 ] && ! [ -e /proc/$$/fd/5 ]"));
}

TEST(ChildProcess, ToleratesAProcessThatNeverReads) {
    auto process = ChildProcess::start({"/bin/true"});
    ASSERT_TRUE(process);
    ASSERT_TRUE(test::comes_true([&] { return !process->is_at_work(); }));
    process->tell("anybody?");
    EXPECT_TRUE(process->has_succeeded());
}

TEST(ChildProcess, EndsWithItsObject) {
    const auto before = std::chrono::steady_clock::now();
    constexpr std::chrono::hours kSleeps(10);
    {
        auto process = ChildProcess::start({"/bin/sleep", "10h"});
        ASSERT_TRUE(process);
        EXPECT_TRUE(process->is_at_work());
        const ChildProcess moved = std::move(*process);
        EXPECT_FALSE(process->is_at_work());
    }
    EXPECT_LT(std::chrono::steady_clock::now() - before, kSleeps) << "it was not waited for";
}

TEST(ChildProcess, AnswersWithAllThatItWrites) {
    auto process = ChildProcess::start({"sh", "-c", "read line; echo \"$line\"; head -c 300000 /dev/zero"},
                                       ChildProcess::Kind::kAnswers);
    ASSERT_TRUE(process) << process.error().message;
    process->tell("celadon");
    std::string answer;
    while (process->read(answer, 10)) {
    }
    EXPECT_EQ(answer.size(), 300008U);
    EXPECT_EQ(answer.substr(0, 8), "celadon\n");
    ASSERT_TRUE(test::comes_true([&] { return !process->is_at_work(); }));
    EXPECT_TRUE(process->has_succeeded());
}

TEST(ChildProcess, DoesNotHoldWhoeverTellsItMoreThanItReads) {
    auto process = ChildProcess::start({"/bin/sleep", "10h"}, ChildProcess::Kind::kAnswers);
    ASSERT_TRUE(process);
    process->tell(std::string(std::size_t{4} << 20U, 'x'));
    std::string answer;
    EXPECT_TRUE(process->read(answer, 1)) << "nothing yet";
    EXPECT_TRUE(answer.empty());
}

TEST(ChildProcess, NamesTheProgramThatIsNotThere) {
    const auto process = ChildProcess::start({"/nowhere/onggi"});
    ASSERT_FALSE(process);
    EXPECT_EQ(process.error().kind, ErrorKind::kSystemLacks);
    EXPECT_NE(process.error().message.find("/nowhere/onggi"), std::string::npos);
}

}  // namespace
}  // namespace onggi::jobs

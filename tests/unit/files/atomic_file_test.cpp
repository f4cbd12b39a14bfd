#include "engine/files/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <optional>
#include <utility>

#include "tests/support/hostile_system.h"
#include "tests/support/temporary_folder.h"

namespace onggi::files {
namespace {

using test::content_of;
using test::put_file;
using test::TemporaryFolder;
using Names = std::vector<std::string>;

const std::string kLarge(std::size_t{3} << 20U, 'x');

class AtomicFileTest : public testing::Test {
  protected:
    const TemporaryFolder folder_;
};

TEST_F(AtomicFileTest, AppearsOnCommitAndNotBefore) {
    auto file = AtomicFile::create(folder_ / "out");
    ASSERT_TRUE(file) << file.error().message;
    ASSERT_TRUE(file->write("hello, "));
    ASSERT_TRUE(file->write("clay"));
    ASSERT_TRUE(file->prepare());
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
    ASSERT_TRUE(file->commit());
    EXPECT_EQ(folder_.names(), Names{"out"});
    EXPECT_EQ(content_of(folder_ / "out"), "hello, clay");
}

TEST_F(AtomicFileTest, LeavesTheOldFileUntilCommit) {
    put_file(folder_ / "out", "old");
    auto file = AtomicFile::create(folder_ / "out");
    ASSERT_TRUE(file);
    ASSERT_TRUE(file->write("new"));
    ASSERT_TRUE(file->prepare());
    EXPECT_EQ(content_of(folder_ / "out"), "old");
    ASSERT_TRUE(file->commit());
    EXPECT_EQ(content_of(folder_ / "out"), "new");
    EXPECT_EQ(folder_.names(), Names{"out"});
}

TEST_F(AtomicFileTest, LeavesNoFileWhenItIsDestroyedOrDiscarded) {
    for (const Beside beside : {Beside::kNameless, Beside::kNamed}) {
        {
            auto file = AtomicFile::create(folder_ / "out", beside);
            ASSERT_TRUE(file);
            ASSERT_TRUE(file->write(kLarge));
        }
        EXPECT_EQ(folder_.names(), Names{});
        auto file = AtomicFile::create(folder_ / "out", beside);
        ASSERT_TRUE(file);
        ASSERT_TRUE(file->write(kLarge));
        file->discard();
        EXPECT_EQ(folder_.names(), Names{});
        EXPECT_FALSE(file->write("more"));
        EXPECT_FALSE(file->commit());
    }
}

TEST_F(AtomicFileTest, CannotBeWrittenAfterCommit) {
    auto file = AtomicFile::create(folder_ / "out");
    ASSERT_TRUE(file);
    ASSERT_TRUE(file->commit());
    EXPECT_FALSE(file->write("late"));
    EXPECT_FALSE(file->commit());
    EXPECT_EQ(content_of(folder_ / "out"), "");
}

TEST_F(AtomicFileTest, TakesMoreThanItsBuffer) {
    auto file = AtomicFile::create(folder_ / "out");
    ASSERT_TRUE(file);
    std::string expected;
    for (int i = 0; i < 30000; ++i) {
        const std::string line = "line " + std::to_string(i) + "\n";
        expected += line;
        ASSERT_TRUE(file->write(line));
    }
    ASSERT_TRUE(file->write(kLarge));
    expected += kLarge;
    ASSERT_TRUE(file->commit());
    EXPECT_TRUE(content_of(folder_ / "out") == expected);
}

TEST_F(AtomicFileTest, KeepsThePermissionsOfTheFileItReplaces) {
    put_file(folder_ / "out", "old");
    std::filesystem::permissions(folder_ / "out", std::filesystem::perms(0640));
    ASSERT_TRUE(write_file_atomically(folder_ / "out", "new"));
    EXPECT_EQ(std::filesystem::status(folder_ / "out").permissions(), std::filesystem::perms(0640));
}

TEST_F(AtomicFileTest, GivesANewFileThePermissionsTheUserLikes) {
    const mode_t before = ::umask(0027);
    for (const Beside beside : {Beside::kNameless, Beside::kNamed}) {
        auto file = AtomicFile::create(folder_ / "out", beside);
        ASSERT_TRUE(file && file->commit());
        EXPECT_EQ(std::filesystem::status(folder_ / "out").permissions(), std::filesystem::perms(0640));
        std::filesystem::remove(folder_ / "out");
    }
    ::umask(before);
}

TEST_F(AtomicFileTest, WritesTheFileBehindALink) {
    put_file(folder_ / "real", "old");
    std::filesystem::create_symlink("real", folder_ / "link");
    ASSERT_TRUE(write_file_atomically(folder_ / "link", "new"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link"));
    EXPECT_EQ(content_of(folder_ / "real"), "new");
}

TEST_F(AtomicFileTest, AcceptsTheLongestPossibleName) {
    const std::string name(255, 'n');
    ASSERT_TRUE(write_file_atomically(folder_ / name, "x"));
    EXPECT_EQ(folder_.names(), Names{name});
}

TEST_F(AtomicFileTest, CanBeMoved) {
    std::optional<AtomicFile> kept;
    {
        auto file = AtomicFile::create(folder_ / "out", Beside::kNamed);
        ASSERT_TRUE(file);
        ASSERT_TRUE(file->write("moved"));
        kept.emplace(std::move(file).value());
    }
    ASSERT_TRUE(kept->commit());
    EXPECT_EQ(folder_.names(), Names{"out"});
    EXPECT_EQ(content_of(folder_ / "out"), "moved");
}

TEST_F(AtomicFileTest, WithoutANameVanishesWithAKilledProgram) {
    const std::string answer = test::in_child([&] {
        auto file = AtomicFile::create(folder_ / "out");
        if (!file || !file->write(kLarge) || !file->prepare()) return std::string("failed");
        ::kill(::getpid(), SIGKILL);
        return std::string("alive");
    });
    EXPECT_EQ(answer, "killed by signal 9");
    EXPECT_EQ(folder_.names(), Names{});
}

TEST_F(AtomicFileTest, WithANameSurvivesAKilledProgram) {
    for (const char* left : {"out.part", "out.part1"}) {
        EXPECT_EQ(test::in_child([&] {
                      auto file = AtomicFile::create(folder_ / "out", Beside::kNamed);
                      if (!file || !file->write("recorded") || !file->flush()) return std::string("failed");
                      ::kill(::getpid(), SIGKILL);
                      return std::string("alive");
                  }),
                  "killed by signal 9");
        EXPECT_EQ(content_of(folder_ / left), "recorded");  // the second does not remove the first one's
    }
}

// The result in a child whose disk is too small: the error's kind and line, and the folder's files.
std::string write_to_full_disk(const TemporaryFolder& folder, Beside beside) {
    test::fill_disk_after(folder.path(), std::size_t{256} << 10U);
    if (auto old = write_file_atomically(folder / "out", "old"); !old) return old.error().message;
    std::string answer;
    auto file = AtomicFile::create(folder / "out", beside);
    if (!file) return file.error().message;
    auto done = file->write(kLarge);
    if (done) done = file->commit();
    if (done) return "written";
    answer += done.error().kind == ErrorKind::kSystemLacks ? "lacks: " : "other: ";
    answer += done.error().message.substr(0, done.error().message.find(": "));
    for (const std::string& name : folder.names())
        answer += " " + name;
    return answer + " " + content_of(folder / "out");
}

TEST_F(AtomicFileTest, OnAFullDiskKeepsTheOldFileAndLeavesNoPart) {
    for (const Beside beside : {Beside::kNameless, Beside::kNamed}) {
        EXPECT_EQ(test::in_child([&] { return write_to_full_disk(folder_, beside); }),
                  "lacks: " + (folder_ / "out").string() + " out old");
    }
}

TEST_F(AtomicFileTest, BeyondTheFileSizeLimitKeepsTheOldFileAndLeavesNoPart) {
    put_file(folder_ / "out", "old");
    EXPECT_EQ(test::in_child([&] {
                  test::limit_file_size(1000);
                  const auto written = write_file_atomically(folder_ / "out", kLarge);
                  if (written) return std::string("written");
                  return std::to_string(exit_code(written.error().kind)) + written.error().message;
              }),
              "3" + (folder_ / "out").string() + ": cannot write: File too large");
    EXPECT_EQ(folder_.names(), Names{"out"});
    EXPECT_EQ(content_of(folder_ / "out"), "old");
}

TEST_F(AtomicFileTest, UsesAHiddenNameWhereNamelessFilesCannotBeNamed) {
    const std::string answer = test::in_child([&] {
        // Without /proc an unnamed file cannot be named.
        if (!test::enter_own_mounts() || ::mount("none", "/proc", "tmpfs", 0, nullptr) != 0)
            return std::string("no mounts");
        auto file = AtomicFile::create(folder_ / "out");
        if (!file || !file->write("x")) return std::string("failed");
        const std::string beside = file->beside().filename();
        if (!file->commit()) return std::string("failed");
        return beside.substr(0, 7) + (std::filesystem::exists(file->beside()) ? " left" : " gone");
    });
    if (answer == "no mounts") GTEST_SKIP() << "this system does not allow private mounts";
    EXPECT_EQ(answer, ".onggi- gone");
    EXPECT_EQ(folder_.names(), Names{"out"});
    EXPECT_EQ(content_of(folder_ / "out"), "x");
}

}  // namespace
}  // namespace onggi::files

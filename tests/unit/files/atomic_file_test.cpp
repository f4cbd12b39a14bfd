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

TEST(AtomicFile, AppearsOnCommitAndNotBefore) {
    const TemporaryFolder folder;
    auto file = AtomicFile::create(folder / "out");
    ASSERT_TRUE(file) << file.error().message;
    ASSERT_TRUE(file->write("hello, "));
    ASSERT_TRUE(file->write("clay"));
    ASSERT_TRUE(file->prepare());
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    ASSERT_TRUE(file->commit());
    EXPECT_EQ(folder.names(), Names{"out"});
    EXPECT_EQ(content_of(folder / "out"), "hello, clay");
}

TEST(AtomicFile, LeavesTheOldFileUntilCommit) {
    const TemporaryFolder folder;
    put_file(folder / "out", "old");
    auto file = AtomicFile::create(folder / "out");
    ASSERT_TRUE(file);
    ASSERT_TRUE(file->write("new"));
    ASSERT_TRUE(file->prepare());
    EXPECT_EQ(content_of(folder / "out"), "old");
    ASSERT_TRUE(file->commit());
    EXPECT_EQ(content_of(folder / "out"), "new");
    EXPECT_EQ(folder.names(), Names{"out"});
}

TEST(AtomicFile, LeavesNothingWhenItIsDestroyedOrDiscarded) {
    const TemporaryFolder folder;
    for (const Beside beside : {Beside::kNameless, Beside::kNamed}) {
        {
            auto file = AtomicFile::create(folder / "out", beside);
            ASSERT_TRUE(file);
            ASSERT_TRUE(file->write(kLarge));
        }
        EXPECT_EQ(folder.names(), Names{});
        auto file = AtomicFile::create(folder / "out", beside);
        ASSERT_TRUE(file);
        ASSERT_TRUE(file->write(kLarge));
        file->discard();
        EXPECT_EQ(folder.names(), Names{});
        EXPECT_FALSE(file->write("more"));
        EXPECT_FALSE(file->commit());
    }
}

TEST(AtomicFile, CannotBeWrittenAfterCommit) {
    const TemporaryFolder folder;
    auto file = AtomicFile::create(folder / "out");
    ASSERT_TRUE(file);
    ASSERT_TRUE(file->commit());
    EXPECT_FALSE(file->write("late"));
    EXPECT_FALSE(file->commit());
    EXPECT_EQ(content_of(folder / "out"), "");
}

TEST(AtomicFile, TakesMoreThanItsBuffer) {
    const TemporaryFolder folder;
    auto file = AtomicFile::create(folder / "out");
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
    EXPECT_TRUE(content_of(folder / "out") == expected);
}

TEST(AtomicFile, KeepsThePermissionsOfTheFileItReplaces) {
    const TemporaryFolder folder;
    put_file(folder / "out", "old");
    std::filesystem::permissions(folder / "out", std::filesystem::perms(0640));
    ASSERT_TRUE(write_file_atomically(folder / "out", "new"));
    EXPECT_EQ(std::filesystem::status(folder / "out").permissions(), std::filesystem::perms(0640));
}

TEST(AtomicFile, GivesANewFileThePermissionsTheUserLikes) {
    const TemporaryFolder folder;
    const mode_t before = ::umask(0027);
    for (const Beside beside : {Beside::kNameless, Beside::kNamed}) {
        auto file = AtomicFile::create(folder / "out", beside);
        ASSERT_TRUE(file && file->commit());
        EXPECT_EQ(std::filesystem::status(folder / "out").permissions(), std::filesystem::perms(0640));
        std::filesystem::remove(folder / "out");
    }
    ::umask(before);
}

TEST(AtomicFile, WritesTheFileBehindALink) {
    const TemporaryFolder folder;
    put_file(folder / "real", "old");
    std::filesystem::create_symlink("real", folder / "link");
    ASSERT_TRUE(write_file_atomically(folder / "link", "new"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
    EXPECT_EQ(content_of(folder / "real"), "new");
}

TEST(AtomicFile, CanTakeTheLongestNameThereIs) {
    const TemporaryFolder folder;
    const std::string name(255, 'n');
    ASSERT_TRUE(write_file_atomically(folder / name, "x"));
    EXPECT_EQ(folder.names(), Names{name});
}

TEST(AtomicFile, CanBeMoved) {
    const TemporaryFolder folder;
    std::optional<AtomicFile> kept;
    {
        auto file = AtomicFile::create(folder / "out", Beside::kNamed);
        ASSERT_TRUE(file);
        ASSERT_TRUE(file->write("moved"));
        kept.emplace(std::move(file).value());
    }
    ASSERT_TRUE(kept->commit());
    EXPECT_EQ(folder.names(), Names{"out"});
    EXPECT_EQ(content_of(folder / "out"), "moved");
}

TEST(AtomicFile, WithoutANameVanishesWithAKilledProgram) {
    const TemporaryFolder folder;
    const std::string answer = test::in_child([&] {
        auto file = AtomicFile::create(folder / "out");
        if (!file || !file->write(kLarge) || !file->prepare()) return std::string("failed");
        ::kill(::getpid(), SIGKILL);
        return std::string("alive");
    });
    EXPECT_EQ(answer, "killed by signal 9");
    EXPECT_EQ(folder.names(), Names{});
}

TEST(AtomicFile, WithANameSurvivesAKilledProgram) {
    const TemporaryFolder folder;
    for (const char* left : {"out.part", "out.part1"}) {
        EXPECT_EQ(test::in_child([&] {
                      auto file = AtomicFile::create(folder / "out", Beside::kNamed);
                      if (!file || !file->write("recorded") || !file->flush()) return std::string("failed");
                      ::kill(::getpid(), SIGKILL);
                      return std::string("alive");
                  }),
                  "killed by signal 9");
        EXPECT_EQ(content_of(folder / left), "recorded");  // nor does the second take the first one's away
    }
}

// What a child finds when its disk is too small: the error's kind and line, and what stands in the folder.
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

TEST(AtomicFile, OnAFullDiskKeepsTheOldFileAndLeavesNothing) {
    const TemporaryFolder folder;
    for (const Beside beside : {Beside::kNameless, Beside::kNamed}) {
        EXPECT_EQ(test::in_child([&] { return write_to_full_disk(folder, beside); }),
                  "lacks: " + (folder / "out").string() + " out old");
    }
}

TEST(AtomicFile, BeyondTheLimitOfFileSizesKeepsTheOldFileAndLeavesNothing) {
    const TemporaryFolder folder;
    put_file(folder / "out", "old");
    EXPECT_EQ(test::in_child([&] {
                  test::limit_file_size(1000);
                  const auto written = write_file_atomically(folder / "out", kLarge);
                  if (written) return std::string("written");
                  return std::to_string(exit_code(written.error().kind)) + written.error().message;
              }),
              "3" + (folder / "out").string() + ": cannot write: File too large");
    EXPECT_EQ(folder.names(), Names{"out"});
    EXPECT_EQ(content_of(folder / "out"), "old");
}

TEST(AtomicFile, UsesAHiddenNameWhereNamelessFilesCannotBeNamed) {
    const TemporaryFolder folder;
    const std::string answer = test::in_child([&] {
        // Without /proc a nameless file can get no name.
        if (!test::enter_own_mounts() || ::mount("none", "/proc", "tmpfs", 0, nullptr) != 0)
            return std::string("no mounts");
        auto file = AtomicFile::create(folder / "out");
        if (!file || !file->write("x")) return std::string("failed");
        const std::string beside = file->beside().filename();
        if (!file->commit()) return std::string("failed");
        return beside.substr(0, 7) + (std::filesystem::exists(file->beside()) ? " left" : " gone");
    });
    if (answer == "no mounts") GTEST_SKIP() << "this system lets nobody have mounts of their own";
    EXPECT_EQ(answer, ".onggi- gone");
    EXPECT_EQ(folder.names(), Names{"out"});
    EXPECT_EQ(content_of(folder / "out"), "x");
}

}  // namespace
}  // namespace onggi::files

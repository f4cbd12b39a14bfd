#include "engine/files/atomic_folder.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

#include "tests/support/temporary_folder.h"

namespace onggi::files {
namespace {

namespace fs = std::filesystem;

TEST(AtomicFolder, IsThereWholeOrNotAtAll) {
    const test::TemporaryFolder folder;
    {
        auto dropped = AtomicFolder::create(folder / "pot");
        ASSERT_TRUE(dropped);
        test::put_file(dropped->inside() / "file", "half");
    }
    EXPECT_TRUE(folder.names().empty());
    auto kept = AtomicFolder::create(folder / "pot");
    ASSERT_TRUE(kept);
    test::put_file(kept->inside() / "file", "whole");
    EXPECT_FALSE(fs::exists(folder / "pot"));
    ASSERT_TRUE(kept->commit());
    EXPECT_EQ(test::content_of(folder / "pot/file"), "whole");
    EXPECT_FALSE(AtomicFolder::create(folder / "pot")) << "it is taken";
}

TEST(AtomicFolder, IsTakenAwayWithAllThatIsInItAndWithWhatAKilledProgramLeft) {
    const test::TemporaryFolder folder;
    fs::create_directories(folder / "pot/inner");
    test::put_file(folder / "pot/inner/file", "pot");
    fs::create_directories(folder / "pot.part");
    test::put_file(folder / "pot.part/old", "half");
    ASSERT_TRUE(take_away_folder(folder / "pot"));
    EXPECT_TRUE(folder.names().empty());
    const auto none = take_away_folder(folder / "pot");
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().kind, ErrorKind::kBadInput);
    EXPECT_EQ(none.error().message, (folder / "pot").string() + ": expected a folder, found none");
}

TEST(AtomicFolder, LeavesNoPartsWhereTheyAreLookedForAndTouchesNothingElse) {
    const test::TemporaryFolder folder;
    for (const char* place : {"day.part/pot", "day/pot.part/inner", "day/pot/inner.part"})
        fs::create_directories(folder / place);
    test::put_file(folder / "file.part", "a file");
    clear_parts(folder.path());
    EXPECT_FALSE(fs::exists(folder / "day.part"));
    EXPECT_TRUE(fs::exists(folder / "day/pot.part"));
    clear_parts(folder.path(), true);
    EXPECT_FALSE(fs::exists(folder / "day/pot.part"));
    EXPECT_TRUE(fs::exists(folder / "day/pot/inner.part"));
    EXPECT_TRUE(fs::exists(folder / "file.part"));
}

TEST(AtomicFolder, TakesAwayFilesBesideOfProcessesThatAreNoMore) {
    const test::TemporaryFolder folder;
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    ::waitpid(child, nullptr, 0);
    const std::string left = ".onggi-" + std::to_string(child) + "-0.part";
    const std::string mine = ".onggi-" + std::to_string(::getpid()) + "-0.part";
    for (const std::string& name : {left, mine, std::string(".onggi-x.part")})
        test::put_file(folder / name, "half");
    clear_parts(folder.path());
    EXPECT_EQ(folder.names().size(), 2U);
    EXPECT_FALSE(fs::exists(folder / left));
}

}  // namespace
}  // namespace onggi::files

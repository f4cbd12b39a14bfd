#include "engine/files/atomic_folder.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace onggi::files

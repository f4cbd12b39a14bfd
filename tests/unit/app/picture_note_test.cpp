#include "game/app/system/picture_note.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

TEST(PictureNote, IsKeptForTheNextRun) {
    const test::TemporaryFolder folder;
    const std::filesystem::path state = folder.path() / "state";
    PictureNote note(state);
    EXPECT_EQ(note.read(), "") << "there was none";
    ASSERT_TRUE(note.keep("slow GPU\ta device"));
    EXPECT_EQ(PictureNote(state).read(), "slow GPU\ta device");
}

TEST(PictureNote, IsWrittenOnlyWhereItIsAnother) {
    const test::TemporaryFolder folder;
    PictureNote note(folder.path());
    ASSERT_TRUE(note.keep("slow GPU\ta device"));
    std::filesystem::remove(folder.path() / "picture");
    ASSERT_TRUE(note.keep("slow GPU\ta device"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "picture"));
    ASSERT_TRUE(note.keep("slower GPU\ta device"));
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "picture"));
}

TEST(PictureNote, IsEmptyForAnInvalidFile) {
    const test::TemporaryFolder folder;
    std::ofstream(folder.path() / "picture") << std::string(100'000, 'x');
    EXPECT_EQ(PictureNote(folder.path()).read(), "");
}

}  // namespace
}  // namespace onggi::app

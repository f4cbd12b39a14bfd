#include <gtest/gtest.h>
#include <sys/stat.h>

#include "engine/files/atomic_file.h"
#include "tests/support/hostile_system.h"
#include "tests/support/temporary_folder.h"

namespace onggi::files {
namespace {

using test::content_of;
using test::put_file;
using test::TemporaryFolder;

void expect_no_place(const std::filesystem::path& place, ErrorKind kind, std::string_view reason) {
    const auto checked = check_output_place(place);
    ASSERT_FALSE(checked) << place;
    EXPECT_EQ(checked.error().kind, kind) << checked.error().message;
    EXPECT_NE(checked.error().message.find(reason), std::string::npos) << checked.error().message;
    EXPECT_EQ(checked.error().message.find('\n'), std::string::npos);
    // Creating the file must give the same error.
    const auto file = AtomicFile::create(place);
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().message, checked.error().message);
}

class OutputPlaceTest : public testing::Test {
  protected:
    const TemporaryFolder folder_;
};

TEST_F(OutputPlaceTest, IsGoodWhereAFileIsOrCouldBe) {
    put_file(folder_ / "old", "old");
    EXPECT_TRUE(check_output_place(folder_ / "new"));
    EXPECT_TRUE(check_output_place(folder_ / "old"));
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"old"});
    EXPECT_EQ(content_of(folder_ / "old"), "old");
}

TEST_F(OutputPlaceTest, IsGoodWithANameAlone) {
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder_.path());
    EXPECT_TRUE(check_output_place("new"));
    std::filesystem::current_path(before);
}

TEST_F(OutputPlaceTest, RejectsAnEmptyName) {
    expect_no_place("", ErrorKind::kBadInput, "found an empty one");
}

TEST_F(OutputPlaceTest, RejectsAFolderThatIsNotThere) {
    expect_no_place(folder_ / "none" / "file", ErrorKind::kBadInput,
                    "the folder " + (folder_ / "none").string() + " is not there");
}

TEST_F(OutputPlaceTest, RejectsAFolderInTheFilesPlace) {
    expect_no_place(folder_.path(), ErrorKind::kBadInput, "expected the place of a file, found a folder");
    expect_no_place(folder_.path() / "", ErrorKind::kBadInput, "found a folder");
}

TEST_F(OutputPlaceTest, RejectsAFileInTheFoldersPlace) {
    put_file(folder_ / "file", "x");
    expect_no_place(folder_ / "file" / "deeper", ErrorKind::kBadInput, "expected a folder at");
}

TEST_F(OutputPlaceTest, RejectsDevicesAndPipesAndLeavesThemBe) {
    ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    expect_no_place(folder_ / "pipe", ErrorKind::kBadInput, "found a pipe");
    expect_no_place("/dev/full", ErrorKind::kBadInput, "found a device");
    expect_no_place("/dev/null", ErrorKind::kBadInput, "found a device");
    EXPECT_TRUE(std::filesystem::is_fifo(folder_ / "pipe"));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(OutputPlaceTest, RejectsADanglingLink) {
    std::filesystem::create_symlink(folder_ / "none", folder_ / "link");
    expect_no_place(folder_ / "link", ErrorKind::kBadInput, "is a link to a file that is not there");
}

TEST_F(OutputPlaceTest, RejectsANameTooLongToBe) {
    expect_no_place(folder_ / std::string(300, 'n'), ErrorKind::kBadInput, "File name too long");
}

TEST_F(OutputPlaceTest, SaysThatTheFolderMayNotBeWrittenIn) {
    std::filesystem::permissions(folder_.path(),
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    const test::WithoutRootRights bound;
    expect_no_place(folder_ / "new", ErrorKind::kSystemLacks, "Permission denied");
}

TEST_F(OutputPlaceTest, SaysThatTheFileMayNotBeWritten) {
    put_file(folder_ / "kept", "kept");
    std::filesystem::permissions(folder_ / "kept", std::filesystem::perms::owner_read);
    const test::WithoutRootRights bound;
    expect_no_place(folder_ / "kept", ErrorKind::kSystemLacks, "Permission denied");
}

}  // namespace
}  // namespace onggi::files

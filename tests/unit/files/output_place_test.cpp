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

void expect_refused(const std::filesystem::path& place, ErrorKind kind, std::string_view reason) {
    const auto checked = check_output_place(place);
    ASSERT_FALSE(checked) << place;
    EXPECT_EQ(checked.error().kind, kind) << checked.error().message;
    EXPECT_NE(checked.error().message.find(reason), std::string::npos) << checked.error().message;
    EXPECT_EQ(checked.error().message.find('\n'), std::string::npos);
    // Nothing else may be said when the file is really made.
    const auto file = AtomicFile::create(place);
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().message, checked.error().message);
}

TEST(OutputPlace, IsGoodWhereAFileIsOrCouldBe) {
    const TemporaryFolder folder;
    put_file(folder / "old", "old");
    EXPECT_TRUE(check_output_place(folder / "new"));
    EXPECT_TRUE(check_output_place(folder / "old"));
    EXPECT_EQ(folder.names(), std::vector<std::string>{"old"});
    EXPECT_EQ(content_of(folder / "old"), "old");
}

TEST(OutputPlace, IsGoodWithANameAlone) {
    const TemporaryFolder folder;
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    EXPECT_TRUE(check_output_place("new"));
    std::filesystem::current_path(before);
}

TEST(OutputPlace, RejectsAnEmptyName) {
    expect_refused("", ErrorKind::kBadInput, "found an empty one");
}

TEST(OutputPlace, RejectsAFolderThatIsNotThere) {
    const TemporaryFolder folder;
    expect_refused(folder / "none" / "file", ErrorKind::kBadInput,
                   "the folder " + (folder / "none").string() + " is not there");
}

TEST(OutputPlace, RejectsAFolderInTheFilesPlace) {
    const TemporaryFolder folder;
    expect_refused(folder.path(), ErrorKind::kBadInput, "expected the place of a file, found a folder");
    expect_refused(folder.path() / "", ErrorKind::kBadInput, "found a folder");
}

TEST(OutputPlace, RejectsAFileInTheFoldersPlace) {
    const TemporaryFolder folder;
    put_file(folder / "file", "x");
    expect_refused(folder / "file" / "deeper", ErrorKind::kBadInput, "expected a folder at");
}

TEST(OutputPlace, RejectsDevicesAndPipesAndLeavesThemBe) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    expect_refused(folder / "pipe", ErrorKind::kBadInput, "found a pipe");
    expect_refused("/dev/full", ErrorKind::kBadInput, "found a device");
    expect_refused("/dev/null", ErrorKind::kBadInput, "found a device");
    EXPECT_TRUE(std::filesystem::is_fifo(folder / "pipe"));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(OutputPlace, RejectsALinkToNothing) {
    const TemporaryFolder folder;
    std::filesystem::create_symlink(folder / "none", folder / "link");
    expect_refused(folder / "link", ErrorKind::kBadInput, "is a link to a file that is not there");
}

TEST(OutputPlace, RejectsANameTooLongToBe) {
    const TemporaryFolder folder;
    expect_refused(folder / std::string(300, 'n'), ErrorKind::kBadInput, "File name too long");
}

TEST(OutputPlace, SaysThatTheFolderMayNotBeWrittenIn) {
    const TemporaryFolder folder;
    std::filesystem::permissions(folder.path(),
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    const test::WithoutRootRights bound;
    expect_refused(folder / "new", ErrorKind::kSystemLacks, "Permission denied");
}

TEST(OutputPlace, SaysThatTheFileMayNotBeWritten) {
    const TemporaryFolder folder;
    put_file(folder / "kept", "kept");
    std::filesystem::permissions(folder / "kept", std::filesystem::perms::owner_read);
    const test::WithoutRootRights bound;
    expect_refused(folder / "kept", ErrorKind::kSystemLacks, "Permission denied");
}

}  // namespace
}  // namespace onggi::files

#include "engine/files/read_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/support/hostile_system.h"
#include "tests/support/temporary_folder.h"

namespace onggi::files {
namespace {

using test::put_file;
using test::TemporaryFolder;

constexpr std::size_t kMegabyte = std::size_t{1} << 20U;

// Refused for the reason given, in one line that begins with the file's name.
void expect_refused(const std::filesystem::path& path, ErrorKind kind, std::string_view reason,
                    std::size_t most_bytes = kMegabyte) {
    const auto bytes = read_file(path, most_bytes);
    ASSERT_FALSE(bytes) << path;
    EXPECT_EQ(bytes.error().kind, kind) << bytes.error().message;
    EXPECT_TRUE(bytes.error().message.starts_with(path.string() + ": ")) << bytes.error().message;
    EXPECT_NE(bytes.error().message.find(reason), std::string::npos) << bytes.error().message;
    EXPECT_EQ(bytes.error().message.find('\n'), std::string::npos);
}

TEST(ReadFile, GivesEveryByte) {
    const TemporaryFolder folder;
    const std::string content("a\0b\r\n\xff", 6);
    put_file(folder / "bytes", content);
    const auto bytes = read_file(folder / "bytes", kMegabyte);
    ASSERT_TRUE(bytes);
    EXPECT_EQ(*bytes, content);
}

TEST(ReadFile, GivesNothingOfAnEmptyFile) {
    const TemporaryFolder folder;
    put_file(folder / "empty", "");
    const auto bytes = read_file(folder / "empty", kMegabyte);
    ASSERT_TRUE(bytes);
    EXPECT_TRUE(bytes->empty());
}

TEST(ReadFile, TakesAFileOfExactlyTheSizeAllowed) {
    const TemporaryFolder folder;
    put_file(folder / "ten", "0123456789");
    const auto bytes = read_file(folder / "ten", 10);
    ASSERT_TRUE(bytes);
    EXPECT_EQ(*bytes, "0123456789");
    expect_refused(folder / "ten", ErrorKind::kBadInput, "expected at most 9 bytes, found 10", 9);
}

TEST(ReadFile, ReadsAFileThatDoesNotSayItsSize) {
    const auto bytes = read_file("/proc/self/status", kMegabyte);
    ASSERT_TRUE(bytes) << bytes.error().message;
    EXPECT_TRUE(bytes->starts_with("Name:")) << *bytes;
    // And notices when it gives more than allowed, though it says 0 bytes.
    expect_refused("/proc/self/status", ErrorKind::kBadInput, "expected at most 10 bytes", 10);
}

TEST(ReadFile, RejectsAFileThatIsNotThere) {
    const TemporaryFolder folder;
    expect_refused(folder / "none", ErrorKind::kBadInput, "no such file");
    expect_refused(folder / "none" / "deeper", ErrorKind::kBadInput, "no such file");
}

TEST(ReadFile, RejectsAFolder) {
    const TemporaryFolder folder;
    expect_refused(folder.path(), ErrorKind::kBadInput, "expected a file, found a folder");
}

TEST(ReadFile, RejectsAPipeWithoutWaitingForItsWriter) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    expect_refused(folder / "pipe", ErrorKind::kBadInput, "expected a file, found a pipe");
}

TEST(ReadFile, RejectsADeviceThatNeverEnds) {
    expect_refused("/dev/zero", ErrorKind::kBadInput, "expected a file, found a device");
}

TEST(ReadFile, RejectsATerabyteWithoutReadingIt) {
    const TemporaryFolder folder;
    put_file(folder / "huge", "x");
    std::filesystem::resize_file(folder / "huge", std::uintmax_t{1} << 40U);
    expect_refused(folder / "huge", ErrorKind::kBadInput, "found 1099511627776");
}

TEST(ReadFile, SaysThatPermissionIsDenied) {
    const TemporaryFolder folder;
    put_file(folder / "secret", "x");
    std::filesystem::permissions(folder / "secret", std::filesystem::perms::none);
    const test::WithoutRootRights bound;
    expect_refused(folder / "secret", ErrorKind::kSystemLacks, "Permission denied");
}

TEST(ReadFile, KeepsItsMessageToOneLineWhateverTheName) {
    const TemporaryFolder folder;
    const auto bytes = read_file(folder / "two\nlines", kMegabyte);
    ASSERT_FALSE(bytes);
    EXPECT_EQ(bytes.error().message, (folder / "two\\x0alines").string() + ": no such file");
}

TEST(ReadFileStart, GivesTheFirstBytesOfWhateverLength) {
    const TemporaryFolder folder;
    put_file(folder / "ten", "0123456789");
    EXPECT_EQ(*read_file_start(folder / "ten", 4), "0123");
    EXPECT_EQ(*read_file_start(folder / "ten", 100), "0123456789");
    EXPECT_EQ(*read_file_start(folder / "ten", 0), "");
    std::filesystem::resize_file(folder / "ten", std::uintmax_t{1} << 40U);
    EXPECT_EQ(*read_file_start(folder / "ten", 4), "0123");
}

}  // namespace
}  // namespace onggi::files

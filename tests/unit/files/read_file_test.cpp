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

class ReadFile : public testing::Test {
  protected:
    const TemporaryFolder folder_;
};

TEST_F(ReadFile, GivesEveryByte) {
    const std::string content("a\0b\r\n\xff", 6);
    put_file(folder_ / "bytes", content);
    const auto bytes = read_file(folder_ / "bytes", kMegabyte);
    ASSERT_TRUE(bytes);
    EXPECT_EQ(*bytes, content);
}

TEST_F(ReadFile, ReturnsNoBytesForAnEmptyFile) {
    put_file(folder_ / "empty", "");
    const auto bytes = read_file(folder_ / "empty", kMegabyte);
    ASSERT_TRUE(bytes);
    EXPECT_TRUE(bytes->empty());
}

TEST_F(ReadFile, TakesAFileOfExactlyTheSizeAllowed) {
    put_file(folder_ / "ten", "0123456789");
    const auto bytes = read_file(folder_ / "ten", 10);
    ASSERT_TRUE(bytes);
    EXPECT_EQ(*bytes, "0123456789");
    expect_refused(folder_ / "ten", ErrorKind::kBadInput, "expected at most 9 bytes, found 10", 9);
}

TEST_F(ReadFile, ReadsAFileThatDoesNotSayItsSize) {
    const auto bytes = read_file("/proc/self/status", kMegabyte);
    ASSERT_TRUE(bytes) << bytes.error().message;
    EXPECT_TRUE(bytes->starts_with("Name:")) << *bytes;
    // Also if the file yields more than allowed although its size is 0.
    expect_refused("/proc/self/status", ErrorKind::kBadInput, "expected at most 10 bytes", 10);
}

TEST_F(ReadFile, RejectsAFileThatIsNotThere) {
    expect_refused(folder_ / "none", ErrorKind::kBadInput, "no such file");
    expect_refused(folder_ / "none" / "deeper", ErrorKind::kBadInput, "no such file");
}

TEST_F(ReadFile, RejectsAFolder) {
    expect_refused(folder_.path(), ErrorKind::kBadInput, "expected a file, found a folder");
}

TEST_F(ReadFile, RejectsAPipeWithoutWaitingForItsWriter) {
    ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    expect_refused(folder_ / "pipe", ErrorKind::kBadInput, "expected a file, found a pipe");
}

TEST_F(ReadFile, RejectsADeviceThatNeverEnds) {
    expect_refused("/dev/zero", ErrorKind::kBadInput, "expected a file, found a device");
}

TEST_F(ReadFile, RejectsATerabyteWithoutReadingIt) {
    put_file(folder_ / "huge", "x");
    std::filesystem::resize_file(folder_ / "huge", std::uintmax_t{1} << 40U);
    expect_refused(folder_ / "huge", ErrorKind::kBadInput, "found 1099511627776");
}

TEST_F(ReadFile, SaysThatPermissionIsDenied) {
    put_file(folder_ / "secret", "x");
    std::filesystem::permissions(folder_ / "secret", std::filesystem::perms::none);
    const test::WithoutRootRights bound;
    expect_refused(folder_ / "secret", ErrorKind::kSystemLacks, "Permission denied");
}

TEST_F(ReadFile, HasAMessageOfOneLineForAnyName) {
    const auto bytes = read_file(folder_ / "two\nlines", kMegabyte);
    ASSERT_FALSE(bytes);
    EXPECT_EQ(bytes.error().message, (folder_ / "two\\x0alines").string() + ": no such file");
}

TEST(ReadFileStart, ReturnsTheFirstBytesOfAnyLength) {
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

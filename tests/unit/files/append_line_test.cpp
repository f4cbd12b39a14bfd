// Appends to a table whose last line may be incomplete.
#include "engine/files/append_line.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace onggi::files {
namespace {

constexpr std::string_view kNames = "day,hour";

TEST(AppendLine, BeginsAFileWithItsFirstLineAndGoesOn) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(append_line(folder / "table", kNames, "1,2"));
    ASSERT_TRUE(append_line(folder / "table", kNames, "3,4"));
    EXPECT_EQ(test::content_of(folder / "table"), "day,hour\n1,2\n3,4\n");
}

TEST(AppendLine, EndsAnIncompleteLineFirst) {
    const test::TemporaryFolder folder;
    test::put_file(folder / "table", "day,hour\n1,2\n3");
    ASSERT_TRUE(append_line(folder / "table", kNames, "5,6"));
    EXPECT_EQ(test::content_of(folder / "table"), "day,hour\n1,2\n3\n5,6\n");
}

TEST(AppendLine, ReplacesAPartialFirstLine) {
    const test::TemporaryFolder folder;
    for (const char* half : {"", "d", "day,hour"}) {
        test::put_file(folder / "table", half);
        ASSERT_TRUE(append_line(folder / "table", kNames, "5,6"));
        EXPECT_EQ(test::content_of(folder / "table"), "day,hour\n5,6\n") << half;
    }
}

TEST(AppendLine, RefusesOtherThanAFileInOneLine) {
    const test::TemporaryFolder folder;
    const auto done = append_line(folder.path(), kNames, "1,2");
    ASSERT_FALSE(done);
    EXPECT_NE(done.error().message.find("cannot append"), std::string::npos) << done.error().message;
    EXPECT_EQ(append_line(folder / "nowhere/table", kNames, "1,2").error().kind, ErrorKind::kBadInput);
}

}  // namespace
}  // namespace onggi::files

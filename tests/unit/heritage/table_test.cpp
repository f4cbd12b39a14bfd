#include "game/heritage/table.h"

#include <gtest/gtest.h>

#include "tests/support/refusal.h"

namespace onggi::heritage {
namespace {

std::string refusal(std::string_view text) {
    return test::refusal(parse_table(text, "a,b,c", "t.csv"));
}

TEST(Table, GivesFieldsAsTheyAreWritten) {
    const auto rows =
        parse_table("a,b,c\n1,,\"x, \"\"y\"\"\"\r\n\"\",\"2\",\xeb\x8b\xac\n", "a,b,c", "t.csv");
    ASSERT_TRUE(rows) << rows.error().message;
    ASSERT_EQ(rows->size(), 2U);
    EXPECT_EQ((*rows)[0].line, 2U);
    EXPECT_EQ((*rows)[0].fields, (std::vector<std::string>{"1", "", "x, \"y\""}));
    EXPECT_EQ((*rows)[1].fields, (std::vector<std::string>{"", "2", "\xeb\x8b\xac"}));
    EXPECT_TRUE(parse_table("a,b,c\n1,2,3", "a,b,c", "t.csv")) << "the last line may lack its end";
}

TEST(Table, RejectsAnotherHeader) {
    EXPECT_EQ(refusal("a,b\n1,2\n"), "t.csv:1: expected the header a,b,c, found 'a,b'");
    EXPECT_EQ(refusal(""), "t.csv:1: expected the header a,b,c, found ''");
    EXPECT_EQ(refusal("\xef\xbb\xbf"
                      "a,b,c\n1,2,3\n"),
              "t.csv:1: expected the header a,b,c, found '\xef\xbb\xbf"
              "a,b,c'");
}

TEST(Table, RejectsRowsThatAreNone) {
    EXPECT_EQ(refusal("a,b,c\n"), "t.csv:2: expected at least one row, found none");
    EXPECT_EQ(refusal("a,b,c\n1,2\n"), "t.csv:2: expected 3 columns, found 2");
    EXPECT_EQ(refusal("a,b,c\n1,2,3\n1,2,3,4\n"), "t.csv:3: expected 3 columns, found 4");
    EXPECT_EQ(refusal("a,b,c\n1,2,3\n\n1,2,3\n"), "t.csv:3: expected 3 columns, found 1");
}

TEST(Table, RejectsQuotesThatDoNotFit) {
    EXPECT_EQ(refusal("a,b,c\n1,\"2,3\n"), "t.csv:2: expected a closing quote, found the end of the line");
    EXPECT_EQ(refusal("a,b,c\n1,2\"2\",3\n"),
              "t.csv:2: expected quotes around a whole field, found '2\"2\"'");
    EXPECT_EQ(refusal("a,b,c\n1,\"2\"x,3\n"),
              "t.csv:2: expected a comma after the closing quote, found 'x,3'");
}

TEST(Table, RejectsWhatIsNoText) {
    EXPECT_EQ(refusal("a,b,c\n1,\t,3\n"), "t.csv:2: column 2: expected text, found '\\x09'");
    EXPECT_EQ(refusal("a,b,c\n1,2,\xff\n"), "t.csv:2: column 3: expected text, found '\\xff'");
    EXPECT_NE(refusal(std::string(kMaxTableBytes + 1, 'x')).find("at most 1048576 bytes"), std::string::npos);
}

}  // namespace
}  // namespace onggi::heritage

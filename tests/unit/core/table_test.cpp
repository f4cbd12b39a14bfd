#include "engine/core/table.h"

#include <gtest/gtest.h>

#include "tests/support/refusal.h"

namespace onggi {
namespace {

using Cells = std::vector<std::string>;

std::string refusal(std::string_view text) {
    return test::refusal(parse_table(text, "t.csv", "a,b,c"));
}

TEST(Table, GivesFieldsAsTheyAreWritten) {
    const auto table =
        parse_table("a,b,c\n1,,\"x, \"\"y\"\"\"\r\n\"\",\"2\",\xeb\x8b\xac\n", "t.csv", "a,b,c");
    ASSERT_TRUE(table) << table.error().message;
    EXPECT_EQ(table->columns, (Cells{"a", "b", "c"}));
    ASSERT_EQ(table->rows.size(), 2U);
    EXPECT_EQ(table->rows[0].line, 2U);
    EXPECT_EQ(table->rows[0].fields, (Cells{"1", "", "x, \"y\""}));
    EXPECT_EQ(table->rows[1].fields, (Cells{"", "2", "\xeb\x8b\xac"}));
    EXPECT_TRUE(parse_table("a,b,c\n1,2,3", "t.csv", "a,b,c")) << "the last line may lack its end";
}

// As editors and spreadsheets of all kinds leave it.
TEST(Table, AcceptsFilesOfCommonEditors) {
    for (const char* text :
         {"\xef\xbb\xbf"
          "a,b,c\n1,2,\n",
          "a,b,c\r\n1,2,\r\n\r\n", "a;b;c\n1;2;\n", "a\tb\tc\n1\t2\t\n", "a,b,c,,\n1,2,,,\n,,,,\n",
          "a,b,c\n1,2\n", "a,b,c\n\n# a note, with commas, and more, of them\n1,2,",
          "\"a\",\"b\",\"c\"\n\"1\",\"2\",\"\"\n",
          "\xef\xbb\xbf"
          "a\tb\tc\r\n1\t2\r\n\r\n"}) {
        const auto table = parse_table(text, "t.csv", "a,b,c");
        ASSERT_TRUE(table) << text << table.error().message;
        ASSERT_EQ(table->rows.size(), 1U) << text;
        EXPECT_EQ(table->rows[0].fields, (Cells{"1", "2", ""})) << text;
    }
}

TEST(Table, TakesQuotesBetweenTabsForTextUnlessOneIsDoubled) {
    const auto table = parse_table("a\tb\tc\n\"one\"\tthe \"b\"\t\"the \"\"c\"\"\"\n", "t.tsv", "a,b,c");
    ASSERT_TRUE(table) << table.error().message;
    EXPECT_EQ(table->rows[0].fields, (Cells{"\"one\"", "the \"b\"", "the \"c\""}));
}

TEST(Table, RejectsAnotherHeader) {
    EXPECT_EQ(refusal("a,b\n1,2\n"), "t.csv:1: expected the header a,b,c, found 'a,b'");
    EXPECT_EQ(refusal(""), "t.csv:1: expected the header a,b,c, found ''");
    EXPECT_EQ(refusal("a,b,c;;;;\nx\n"), "t.csv:1: expected 3 columns, found 1 between ';'");
    EXPECT_EQ(refusal("a,b\xc2\xa0,c\n1,2,3\n"),
              "t.csv:1: expected the header a,b,c, found 'a,b\\xc2\\xa0,c'");
}

TEST(Table, RejectsInvalidRows) {
    EXPECT_EQ(refusal("a,b,c\n1,2,3\n1,2,3,4\n"), "t.csv:3: expected 3 columns, found 4");
}

TEST(Table, RejectsQuotesThatDoNotFit) {
    EXPECT_EQ(refusal("a,b,c\n1,\"2,3\n"), "t.csv:2: expected a closing quote, found the end of the line");
    EXPECT_EQ(refusal("a,b,c\n1,2\"2\",3\n"),
              "t.csv:2: expected quotes around a whole field, found '2\"2\"'");
    EXPECT_EQ(refusal("a,b,c\n1,\"2\"x,3\n"), "t.csv:2: expected ',' after the closing quote, found 'x,3'");
}

TEST(Table, RejectsInvalidText) {
    EXPECT_EQ(refusal("a,b,c\n1,\t,3\n"), "t.csv:2: column 2: expected text, found '\\x09'");
    EXPECT_EQ(refusal("a,b,c\n1,2,\xff\n"), "t.csv:2: column 3: expected text, found '\\xff'");
    EXPECT_NE(refusal(std::string(kMaxTableBytes + 1, 'x')).find("at most 1048576 bytes"), std::string::npos);
}

}  // namespace
}  // namespace onggi

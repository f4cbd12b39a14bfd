#include "game/sharing/share_code.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

namespace onggi::sharing {
namespace {

TEST(ShareCode, IsEightLettersByChance) {
    std::set<std::string> seen;
    std::map<char, int> letters;
    for (int i = 0; i < 4000; ++i) {
        const auto code = ShareCode::by_chance();
        ASSERT_TRUE(code) << code.error().message;
        ASSERT_EQ(code->text().size(), 8U);
        seen.insert(code->text());
        for (const char letter : code->text())
            ++letters[letter];
    }
    EXPECT_EQ(seen.size(), 4000U) << "two of 4000 among 2^40 would be one chance in 140,000";
    EXPECT_EQ(letters.size(), 32U);
    for (const auto& [letter, count] : letters) {
        // 1000 each are expected, with a deviation of 31.
        EXPECT_NEAR(count, 1000, 250) << letter;
        EXPECT_EQ(std::string("ILOU").find(letter), std::string::npos);
    }
}

TEST(ShareCode, AcceptsTypedVariants) {
    for (const char* typed :
         {"K73F0TX1", "k73f0tx1", "K73F-0TX1", " k73f.otxl ", "K73F·OTXI", "k7 3f_0t x1"}) {
        const auto code = ShareCode::read(typed);
        ASSERT_TRUE(code) << typed;
        EXPECT_EQ(code->text(), "K73F0TX1") << typed;
    }
    EXPECT_EQ(ShareCode::read("K73F0TX1")->shown(), "K73F·0TX1");
}

TEST(ShareCode, RejectsInvalidCodes) {
    for (const char* typed : {"", "K73F0TX", "K73F0TX11", "K73F0TXU", "K73F/TX1", "../../..", "K73F0T%31",
                              "ㅏ73F0TX1", "K73F0TX1\n", "--------"})
        EXPECT_FALSE(ShareCode::read(typed)) << typed;
    const std::string with_nothing("K73F\0TX1", 8);
    EXPECT_FALSE(ShareCode::read(with_nothing));
    for (const char* text : {"k73f0tx1", "K73F0TXI", "K73F-0TX1", "K73F0TX"})
        EXPECT_FALSE(ShareCode::read_exactly(text)) << text;
    EXPECT_TRUE(ShareCode::read_exactly("K73F0TX1"));
}

}  // namespace
}  // namespace onggi::sharing

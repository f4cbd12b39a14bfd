#include "engine/asset/utf8.h"

#include <gtest/gtest.h>

namespace onggi::asset {
namespace {

constexpr const char* kMark = "\xEF\xBF\xBD";  // U+FFFD

std::string marks(int count) {
    std::string text;
    for (int i = 0; i < count; ++i)
        text += kMark;
    return text;
}

TEST(ValidUtf8, LeavesWellFormedTextAlone) {
    for (const std::string text :
         {"", "pot", "옹기", "é", "😀", "\x7F", "\xF4\x8F\xBF\xBF", "\xED\x9F\xBF", "\xEE\x80\x80"}) {
        EXPECT_EQ(valid_utf8(text), text);
    }
}

TEST(ValidUtf8, ReplacesInvalidBytes) {
    EXPECT_EQ(valid_utf8("caf\xE9"), "caf" + marks(1));  // Latin-1
    EXPECT_EQ(valid_utf8("\xE9t\xE9"), marks(1) + "t" + marks(1));
    EXPECT_EQ(valid_utf8("\xC0\x80"), marks(2));  // overlong
    EXPECT_EQ(valid_utf8("\xE0\x9F\xBF"), marks(3));
    EXPECT_EQ(valid_utf8("\xF0\x8F\xBF\xBF"), marks(4));
    EXPECT_EQ(valid_utf8("\xED\xA0\x80"), marks(3));      // a surrogate
    EXPECT_EQ(valid_utf8("\xF4\x90\x80\x80"), marks(4));  // above U+10FFFF
    EXPECT_EQ(valid_utf8("\xFF"), marks(1));
    EXPECT_EQ(valid_utf8("\xEC\x98"), marks(2));  // cut in the middle
    EXPECT_EQ(valid_utf8("\xEC\x98x"), marks(2) + "x");
    EXPECT_EQ(valid_utf8("\xF0\x9F\x98"), marks(3));
}

TEST(ValidUtf8, ReturnsTextThatIsStable) {
    for (int a = 0; a < 256; ++a) {
        for (int b = 0; b < 256; ++b) {
            const std::string bytes{static_cast<char>(a), static_cast<char>(b), 'x'};
            const std::string once = valid_utf8(bytes);
            EXPECT_EQ(valid_utf8(once), once) << a << ' ' << b;
        }
    }
}

}  // namespace
}  // namespace onggi::asset

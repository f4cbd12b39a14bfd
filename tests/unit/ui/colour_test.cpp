#include "engine/ui/colour.h"

#include <gtest/gtest.h>

namespace onggi::ui {
namespace {

TEST(Colour, ReadsHexAsDesignersWriteIt) {
    EXPECT_EQ(hex(0xff0000), (Colour{1.0F, 0.0F, 0.0F, 1.0F}));
    EXPECT_FLOAT_EQ(hex(0x336699, 0.5F).g, 0.4F);
}

TEST(Colour, CountsContrastAsTheStandardDoes) {
    EXPECT_NEAR(contrast(hex(0xffffff), hex(0x000000)), 21.0F, 1e-3F);
    EXPECT_NEAR(contrast(hex(0x777777), hex(0xffffff)), 4.48F, 0.01F);  // WCAG's own border case
    EXPECT_FLOAT_EQ(contrast(hex(0x123456), hex(0x123456)), 1.0F);
}

TEST(Colour, LaysOneOverAnother) {
    EXPECT_EQ(over(hex(0xffffff, 0.0F), hex(0x102030)), hex(0x102030));
    EXPECT_NEAR(over(hex(0xffffff, 0.5F), hex(0x000000)).r, 0.5F, 1e-6F);
}

}  // namespace
}  // namespace onggi::ui

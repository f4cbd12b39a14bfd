// The foot pedal's reports, as captured in public.
#include "engine/haptics/hid/simple_drivers.h"

#include <gtest/gtest.h>

#include "tests/support/hex.h"

namespace onggi::haptics::hid {
namespace {

using testing::hex;

TEST(VecPedal, TellsItsThreePedalsApart) {
    const auto left = vec_pedal_state(hex("01 00"));
    const auto middle = vec_pedal_state(hex("02 00"));
    const auto right = vec_pedal_state(hex("04 00"));
    const auto all = vec_pedal_state(hex("07 00"));
    const auto none = vec_pedal_state(hex("00 00"));
    ASSERT_TRUE(left && middle && right && all && none);
    EXPECT_TRUE(left->left && !left->middle && !left->right);
    EXPECT_TRUE(!middle->left && middle->middle && !middle->right);
    EXPECT_TRUE(!right->left && !right->middle && right->right);
    EXPECT_TRUE(all->left && all->middle && all->right);
    EXPECT_FALSE(none->any());
}

TEST(VecPedal, RejectsReportsOfAnythingElse) {
    for (const char* report : {"", "01", "01 00 00", "08 00", "00 01"})
        EXPECT_FALSE(vec_pedal_state(hex(report))) << report;
}

}  // namespace
}  // namespace onggi::haptics::hid

// Help along a drawn outline: felt near it, never seen.
#include "game/app/kiosk/finger/kiosk_finger.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace onggi::app {
namespace {

// A cone that widens from 40 at the foot to 60 at 100 mm.
constexpr std::array kCone{vec2(40.0F, 0.0F), vec2(60.0F, 100.0F)};

OutlineHelp settled(double strength) {
    OutlineHelp help;
    help.set(kCone, strength);
    for (int frame = 0; frame < 600; ++frame)
        help.pass_time(1.0 / 60.0);
    return help;
}

TEST(OutlineHelp, DrawsAFingerThatIsNearAndNoOther) {
    const OutlineHelp help = settled(1.0);
    for (const double side : {1.0, -1.0}) {
        const dvec2 near = help.drawn({side * 53.0, 50.0});
        EXPECT_GT(side * near.x, 50.0) << "not past it";
        EXPECT_LT(side * near.x, 52.0);
        EXPECT_EQ(near.y, 50.0);
        EXPECT_GT(side * help.drawn({side * 47.0, 50.0}).x, 48.0) << "from inside as well";
        EXPECT_EQ(help.drawn({side * 57.0, 50.0}).x, side * 57.0);
        EXPECT_EQ(help.drawn({side * 30.0, 50.0}).x, side * 30.0);
    }
    EXPECT_EQ(help.drawn({62.0, 107.0}).x, 62.0) << "there is no outline";
}

TEST(OutlineHelp, IsNeverSeenAsAJumpNorGoesAnyWayBack) {
    const OutlineHelp help = settled(1.0);
    double last = help.drawn({30.0, 50.0}).x;
    for (double x = 30.0; x < 70.0; x += 0.05) {
        const double now = help.drawn({x, 50.0}).x;
        EXPECT_LE(std::abs(now - x), 4.0);
        EXPECT_GE(now, last - 1e-12) << x;
        EXPECT_LT(now - last, 0.1) << x;
        last = now;
    }
    double before = help.drawn({62.0, 90.0}).x;
    for (double y = 90.0; y < 110.0; y += 0.05) {
        const double now = help.drawn({62.0, y}).x;
        EXPECT_LT(std::abs(now - before), 0.1) << y;
        before = now;
    }
}

TEST(OutlineHelp, ComesAndGoesGentlyAndByItsStrength) {
    OutlineHelp help;
    EXPECT_EQ(help.drawn({53.0, 50.0}).x, 53.0);
    help.set(kCone, 1.0);
    help.pass_time(1.0 / 60.0);
    EXPECT_GT(help.drawn({53.0, 50.0}).x, 52.9) << "it does not pull at once";
    EXPECT_GT(settled(0.5).drawn({53.0, 50.0}).x, settled(1.0).drawn({53.0, 50.0}).x);
    help = settled(1.0);
    help.set({}, 0.0);
    help.pass_time(1.0 / 60.0);
    EXPECT_LT(help.drawn({53.0, 50.0}).x, 52.0);
    for (int frame = 0; frame < 600; ++frame)
        help.pass_time(1.0 / 60.0);
    EXPECT_NEAR(help.drawn({53.0, 50.0}).x, 53.0, 0.01);
}

TEST(OutlineHelp, TakesNoNonsense) {
    OutlineHelp help;
    constexpr std::array kPoint{vec2(40.0F, 0.0F)};
    for (const double strength : {std::nan(""), -1.0, 1e300}) {
        help.set(kPoint, strength);
        help.pass_time(1.0);
        EXPECT_EQ(help.drawn({41.0, 0.0}).x, 41.0);
    }
}

}  // namespace
}  // namespace onggi::app

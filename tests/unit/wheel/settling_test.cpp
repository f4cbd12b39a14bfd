#include "game/wheel/components.h"

#include <gtest/gtest.h>

namespace onggi::wheel {
namespace {

TEST(Settling, IsTheSameInOneStepAsInAThousand) {
    const Settling start{.value = 3.0, .speed = -2.0};
    Settling stepped = start;
    for (int i = 0; i < 1000; ++i)
        stepped = settled(stepped, 10.0, 4.0, 0.7 / 1000.0);
    const Settling once = settled(start, 10.0, 4.0, 0.7);
    EXPECT_NEAR(stepped.value, once.value, 1e-9);
    EXPECT_NEAR(stepped.speed, once.speed, 1e-9);
}

TEST(Settling, NeverSwingsPastItsGoalFromRest) {
    Settling now;
    double before = 0.0;
    for (int i = 0; i < 600; ++i) {
        now = settled(now, 1.0, 4.0, 1.0 / 60.0);
        EXPECT_GE(now.value, before);
        EXPECT_LE(now.value, 1.0);
        before = now.value;
    }
    EXPECT_NEAR(now.value, 1.0, 1e-9);
}

}  // namespace
}  // namespace onggi::wheel

#include "game/clay/wheel_angle.h"

#include <gtest/gtest.h>

#include <cmath>

namespace onggi::clay {
namespace {

TEST(WheelAngle, StartsAlongX) {
    const WheelAngle wheel;
    EXPECT_EQ(wheel.heading().cosine, 1.0);
    EXPECT_EQ(wheel.heading().sine, 0.0);
}

TEST(WheelAngle, StaysAUnitVectorAndOnItsAngleForAMillionSteps) {
    for (const double step_rad : {12.566370614359172 / 1000.0, 12.566370614359172 / 4000.0, 0.314, 1e-7}) {
        WheelAngle wheel;
        for (int step = 0; step < 1000000; ++step)
            wheel.turn(step_rad);
        const double exact_rad = 1e6 * step_rad;
        EXPECT_NEAR(std::hypot(wheel.heading().cosine, wheel.heading().sine), 1.0, 1e-15);
        EXPECT_NEAR(wheel.heading().cosine, std::cos(exact_rad), 2e-10) << step_rad;
        EXPECT_NEAR(wheel.heading().sine, std::sin(exact_rad), 2e-10) << step_rad;
    }
}

TEST(WheelAngle, FollowsAChangingSpeedAndBack) {
    WheelAngle wheel;
    double turned_rad = 0.0;
    for (int step = 0; step < 1000; ++step) {
        const double step_rad = step * 1e-5;
        wheel.turn(step_rad);
        turned_rad += step_rad;
    }
    EXPECT_NEAR(wheel.heading().cosine, std::cos(turned_rad), 1e-12);
    EXPECT_NEAR(wheel.heading().sine, std::sin(turned_rad), 1e-12);
    wheel.turn(-turned_rad);
    EXPECT_NEAR(wheel.heading().cosine, 1.0, 1e-12);
    EXPECT_NEAR(wheel.heading().sine, 0.0, 1e-12);
}

TEST(WheelAngle, GoesOnFromARecordedHeadingWithTheSameBits) {
    WheelAngle wheel;
    for (int step = 0; step < 100; ++step)
        wheel.turn(0.0125);
    WheelAngle restored(wheel.heading());
    for (int step = 0; step < 100; ++step) {
        wheel.turn(0.0125);
        restored.turn(0.0125);
    }
    EXPECT_EQ(restored.heading().cosine, wheel.heading().cosine);
    EXPECT_EQ(restored.heading().sine, wheel.heading().sine);
}

TEST(WheelAngle, StandsStillWithoutLosingABit) {
    WheelAngle wheel;
    wheel.turn(0.7);
    wheel.turn(0.0);
    const Rotation before = wheel.heading();
    for (int step = 0; step < 1000; ++step)
        wheel.turn(0.0);
    EXPECT_NEAR(wheel.heading().cosine, before.cosine, 2e-16);
    EXPECT_NEAR(wheel.heading().sine, before.sine, 2e-16);
}

}  // namespace
}  // namespace onggi::clay

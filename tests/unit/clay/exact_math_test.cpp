#include "game/clay/exact_math.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace onggi::clay {
namespace {

TEST(Power, IsWithinOneInABillionthOfLibmOverTheWholeRangeOfTheTick) {
    double worst = 0.0;
    for (int i = 1; i < 4000; ++i) {
        const double base = i / 4000.0;
        for (double exponent = 0.1; exponent <= 10.0; exponent += 0.0173) {
            worst = std::max(worst, std::fabs(power(base, exponent) - std::pow(base, exponent)));
        }
    }
    EXPECT_LT(worst, 1e-12);
    EXPECT_LT(worst, 1e-14) << "as good as it was";
}

TEST(Power, IsExactAtTheEndsOfItsRange) {
    EXPECT_NEAR(power(1e-16, 0.1), std::pow(1e-16, 0.1), 1e-12);
    EXPECT_NEAR(power(1e-16, 10.0), std::pow(1e-16, 10.0), 1e-12);
    for (const double small : {1e-3, 1e-9, 1e-15, 1.2e-16}) {
        EXPECT_NEAR(power(1.0 - small, 0.1), std::pow(1.0 - small, 0.1), 1e-12);
        EXPECT_NEAR(power(1.0 - small, 10.0), std::pow(1.0 - small, 10.0), 1e-12);
    }
    EXPECT_EQ(power(1.0, 3.3), 1.0);
    EXPECT_EQ(power(0.0, 3.3), 0.0);
    EXPECT_EQ(power(-1.0, 3.3), 0.0);
    EXPECT_EQ(power(std::numeric_limits<double>::quiet_NaN(), 1.0), 0.0);
    EXPECT_EQ(power(1e-300, 10.0), 0.0);  // far below the smallest number
}

TEST(Power, OfOneIsTheBaseToTheBit) {
    for (double base = 0.0007; base < 1.0; base += 0.0007)
        EXPECT_EQ(power(base, 1.0), base);
}

TEST(RotationBy, IsWithinOneInABillionthOfLibm) {
    double worst = 0.0;
    for (int i = -500000; i <= 500000; ++i) {
        const double angle_rad = i * 0.002;
        const Rotation rotation = rotation_by(angle_rad);
        worst = std::max(worst, std::fabs(rotation.cosine - std::cos(angle_rad)));
        worst = std::max(worst, std::fabs(rotation.sine - std::sin(angle_rad)));
    }
    EXPECT_LT(worst, 1e-12);
    // The steps of a wheel: 0 to 300 rev/min at 100 Hz to 10 kHz.
    double worst_step = 0.0;
    for (double angle_rad = 0.0; angle_rad < 0.32; angle_rad += 1e-6) {
        const Rotation rotation = rotation_by(angle_rad);
        worst_step = std::max(worst_step, std::fabs(rotation.cosine - std::cos(angle_rad)));
        worst_step = std::max(worst_step, std::fabs(rotation.sine - std::sin(angle_rad)));
    }
    EXPECT_LT(worst_step, 3e-16);
}

TEST(RotationBy, IsExactAtZeroAndTheQuarters) {
    constexpr double kHalfPi = 1.5707963267948966;
    EXPECT_EQ(rotation_by(0.0).cosine, 1.0);
    EXPECT_EQ(rotation_by(0.0).sine, 0.0);
    EXPECT_NEAR(rotation_by(kHalfPi).sine, 1.0, 1e-15);
    EXPECT_NEAR(rotation_by(2.0 * kHalfPi).cosine, -1.0, 1e-15);
    EXPECT_NEAR(rotation_by(-kHalfPi).sine, -1.0, 1e-15);
    EXPECT_NEAR(rotation_by(-2.0 * kHalfPi).cosine, -1.0, 1e-15);
}

}  // namespace
}  // namespace onggi::clay

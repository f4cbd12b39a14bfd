#include "engine/haptics/velocity_estimator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace onggi::haptics {
namespace {

constexpr double kEstimatedRates[] = {250.0, 500.0, 1000.0, 4000.0, 10000.0};
constexpr double kStepMm = 0.055;

double read(double x_mm) {
    return std::round(x_mm / kStepMm) * kStepMm;
}

TEST(VelocityEstimator, IsExactForAnEvenMotionWithoutSteps) {
    for (const double rate_hz : kEstimatedRates) {
        VelocityEstimator estimator;
        dvec3 v(0.0);
        for (int k = 0; k < 500; ++k) {
            const double t = k / rate_hz;
            v = estimator.update({60.0 - 100.0 * t, 5.0 * t, 0.25}, 1.0 / rate_hz);
        }
        EXPECT_NEAR(v.x, -100.0, 1e-6) << rate_hz;
        EXPECT_NEAR(v.y, 5.0, 1e-6) << rate_hz;
        EXPECT_EQ(v.z, 0.0) << rate_hz;
    }
}

TEST(VelocityEstimator, HasAFractionOfTheNoiseOfADifferenceQuotient) {
    // Half a step over 15 ms is 3.7 mm/s; the difference of two readings is wrong by up to 220 mm/s at 4 kHz.
    for (const double rate_hz : kEstimatedRates) {
        for (const double v_mm_s : {0.0, 3.0, 20.0, 200.0}) {
            VelocityEstimator estimator(kStepMm);
            double worst = 0.0;
            double worst_difference = 0.0;
            double before = 0.0;
            for (int k = 0; k < static_cast<int>(rate_hz); ++k) {
                const double x = read(v_mm_s * k / rate_hz);
                const double v = estimator.update({x, 0.0, 0.0}, 1.0 / rate_hz).x;
                if (k > rate_hz * 0.05) {
                    worst = std::max(worst, std::abs(v - v_mm_s));
                    worst_difference = std::max(worst_difference, std::abs((x - before) * rate_hz - v_mm_s));
                }
                before = x;
            }
            EXPECT_LT(worst, 2.5 * kStepMm / VelocityEstimator::kWindowS) << rate_hz << ' ' << v_mm_s;
            if (rate_hz >= 1000.0 && v_mm_s > 0.0) {
                EXPECT_GT(worst_difference, 3.0 * worst) << rate_hz << ' ' << v_mm_s;
            }
        }
    }
}

TEST(VelocityEstimator, FollowsAToolThatTurnsAroundWithinAFewMilliseconds) {
    VelocityEstimator estimator(kStepMm);
    double turned_s = 0.0;
    for (int k = 0; k < 4000; ++k) {
        const double t = k / 4000.0;
        const double x = t < 0.5 ? 200.0 * t : 100.0 - 200.0 * (t - 0.5);
        const double v = estimator.update({read(x), 0.0, 0.0}, 1.0 / 4000.0).x;
        if (t > 0.5 && v > -150.0) turned_s = t - 0.5;
    }
    EXPECT_LT(turned_s, 0.004);
}

TEST(VelocityEstimator, CountsTheTimeThatReallyPassed) {
    VelocityEstimator estimator;
    double x = 0.0;
    dvec3 v(0.0);
    for (int k = 0; k < 100; ++k) {
        const double dt_s = k % 7 == 0 ? 0.002 : 0.001;
        x += 50.0 * dt_s;
        v = estimator.update({x, 0.0, 0.0}, dt_s);
    }
    EXPECT_NEAR(v.x, 50.0, 1e-6);
}

TEST(VelocityEstimator, StartsAtZeroIgnoresNonsenseAndForgetsWhenTold) {
    VelocityEstimator estimator;
    EXPECT_EQ(estimator.update({500.0, 0.0, 0.0}, 0.001), dvec3(0.0));
    EXPECT_NEAR(estimator.update({500.1, 0.0, 0.0}, 0.001).x, 100.0, 1e-6);
    EXPECT_NEAR(estimator.update({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}, 0.001).x, 100.0, 1e-6);
    estimator.restart();
    EXPECT_EQ(estimator.update({-500.0, 0.0, 0.0}, 0.001), dvec3(0.0));
}

}  // namespace
}  // namespace onggi::haptics

#include <gtest/gtest.h>

#include <limits>

#include "game/clay/paper_clay.h"

namespace onggi::clay {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(PaperParameters, AreThoseOfThePaperUnlessSet) {
    EXPECT_TRUE(check({}));
    EXPECT_TRUE(check({.rate_hz = 100.0}));
    EXPECT_TRUE(check({.rate_hz = 10000.0}));
    EXPECT_TRUE(check({.softness_c1_per_mm = 0.51}));
    EXPECT_TRUE(
        check({.viscosity_c2_n_s_per_mm = 0.0, .friction_c3_n_s_per_mm = 0.0, .wheel_speed_rad_s = 0.0}));
}

TEST(PaperParameters, RejectsAC1WithWhichC1R1IsNotAbove1) {
    for (const double c1 : {0.5, 0.1, 0.0, -10.0, kNaN, kInfinity}) {
        const Result<void> checked = check({.softness_c1_per_mm = c1});
        ASSERT_FALSE(checked) << c1;
        EXPECT_EQ(checked.error().kind, ErrorKind::kBadInput);
    }
    EXPECT_EQ(
        check({.softness_c1_per_mm = 0.25}).error().message,
        "clay parameter softness c1, 1/mm: expected more than 0.5 (so that c1 r1 > 1 for the smallest tool, "
        "2 mm) and at most 1e6, found 0.25");
}

TEST(PaperParameters, RejectsARateNoLoopRunsAt) {
    for (const double rate_hz : {0.0, 99.9, 10000.1, -1000.0, kNaN, kInfinity}) {
        EXPECT_FALSE(check({.rate_hz = rate_hz})) << rate_hz;
    }
    EXPECT_EQ(check({.rate_hz = 50.0}).error().message,
              "clay parameter rate, Hz: expected 100 to 10000, found 50");
}

TEST(PaperParameters, RejectsNegativeNumbersAndNan) {
    for (const double bad : {-1e-9, kNaN, kInfinity, -kInfinity}) {
        EXPECT_FALSE(check({.viscosity_c2_n_s_per_mm = bad})) << bad;
        EXPECT_FALSE(check({.friction_c3_n_s_per_mm = bad})) << bad;
        EXPECT_FALSE(check({.stiffness_turning_n_per_mm = bad})) << bad;
        EXPECT_FALSE(check({.stiffness_standing_n_per_mm = bad})) << bad;
        EXPECT_FALSE(check({.wheel_speed_rad_s = bad})) << bad;
        EXPECT_FALSE(check({.minimum_radius_mm = bad})) << bad;
    }
    EXPECT_FALSE(check({.minimum_radius_mm = 0.0}));
}

}  // namespace
}  // namespace onggi::clay

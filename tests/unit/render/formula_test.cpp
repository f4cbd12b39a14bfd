// The formulas of light compile for one float and for eight: both must give the same results.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/math/float8.h"
#include "engine/math/math.h"
#include "shaders/hand.h"
#include "shaders/lathe.h"
#include "shaders/shadow.h"
#include "shaders/transfer.h"
#include "tests/unit/render/exact_screen.h"

namespace onggi {
namespace {

constexpr Float8 kCosines{-1.0F, -0.4F, -0.05F, 0.0F, 0.2F, 0.5F, 0.9F, 1.0F};

// Evaluates `of` for eight values at once and one by one; returns by reference, since vectors are not passed
// by value.
template <typename Formula>
void expect_the_same(const Float8& numbers, Formula of) {
    Float8 wide;
    of(numbers, wide);
    for (int i = 0; i < kFloat8; ++i) {
        const float number = numbers[i];
        float alone = 0.0F;
        of(number, alone);
        EXPECT_EQ(wide[i], alone) << number;
    }
}

TEST(Formula, FindsTheSameOfANumberAndOfEight) {
    expect_the_same(kCosines,
                    [](const auto& n_l, auto& into) { into = shaders::soft_cosine(n_l, 0.3F, 1.0F / 0.3F); });
    expect_the_same(kCosines,
                    [](const auto& n_l, auto& into) { into = shaders::hand_gleam(n_l, 0.7F, 0.2F, 0.4F); });
    expect_the_same(kCosines, [](const auto& y, auto& into) { into = shaders::sky_height(y); });
    expect_the_same(kCosines, [](const auto& s, auto& into) { into = shaders::fujii_t(s, 0.3F, 0.6F); });
    expect_the_same(200.0F * (kCosines + 1.0F),
                    [](const auto& mm, auto& into) { into = shaders::ground_open(mm); });
}

TEST(Formula, OfAPowerOfEIsWrongByLittle) {
    for (float number = 0.0F; number > -20.0F; number -= 0.37F) {
        const float exact = std::exp(number);
        EXPECT_NEAR(float8::exp_below_0(number), exact, 2e-5F * exact) << number;
    }
    EXPECT_EQ(float8::exp_below_0(-1000.0F), float8::exp_below_0(-87.0F)) << "no lower than a float goes";
}

TEST(Formula, OfTheScreensTransferIsTheStandardsWithinATenthOfALevelAndBackWithinAThird) {
    constexpr int kSteps = 100'000;
    for (int i = 0; i <= kSteps; ++i) {
        const double number = static_cast<double>(i) / kSteps;
        const auto light = static_cast<float>(number);
        ASSERT_NEAR(255.0 * double{shaders::transferred(light)}, 255.0 * render::exact_transferred(number),
                    0.1)
            << number;
        ASSERT_NEAR(255.0 * render::exact_transferred(double{shaders::untransferred(light)}), 255.0 * number,
                    0.33)
            << number;
    }
    expect_the_same(0.5F * (kCosines + 1.0F),
                    [](const auto& c, auto& into) { into = shaders::transferred(c); });
    expect_the_same(0.5F * (kCosines + 1.0F),
                    [](const auto& v, auto& into) { into = shaders::untransferred(v); });
}

TEST(Formula, OfASphereHidesOnlyPointsBehindIt) {
    const vec4 sphere(0.0F, 50.0F, 0.0F, 10.0F);
    const vec3 up(0.0F, 1.0F, 0.0F);
    EXPECT_EQ(shaders::past_sphere(sphere, up, 0.05F, vec3(0.0F)), 0.0F);
    EXPECT_EQ(shaders::past_sphere(sphere, up, 0.05F, vec3(40.0F, 0.0F, 0.0F)), 1.0F);
    EXPECT_EQ(shaders::past_sphere(sphere, up, 0.05F, vec3(0.0F, 100.0F, 0.0F)), 1.0F) << "above it";
    EXPECT_NEAR(shaders::sky_past_sphere(sphere, vec3(0.0F), up), 1.0F - 100.0F / 2500.0F, 1e-6F);
    EXPECT_EQ(shaders::sky_past_sphere(sphere, vec3(0.0F), -up), 1.0F) << "it looks away";
}

}  // namespace
}  // namespace onggi

#include "game/wheel/camera_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace onggi::wheel {
namespace {

constexpr CameraPose kThrowing{
    .out_mm = 805.0, .up_mm = 285.0, .target_mm = {0.0, 82.0, 0.0}, .vertical_fov_rad = 0.471};
constexpr CameraPose kLookingIn{
    .out_mm = 610.0, .up_mm = 640.0, .target_mm = {0.0, 70.0, 0.0}, .vertical_fov_rad = 0.4887};

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

TEST(Travelling, GoesOnAsItCameAndEndsAtItsGoalStandingStill) {
    const Travelling start{.value = 3.0, .speed = -2.0, .acceleration = 5.0};
    const Travelling first = travelled(start, 10.0, 0.0, 0.8);
    EXPECT_EQ(first.value, start.value);
    EXPECT_DOUBLE_EQ(first.speed, start.speed);
    EXPECT_DOUBLE_EQ(first.acceleration, start.acceleration);
    const Travelling last = travelled(start, 10.0, 1.0, 0.8);
    EXPECT_NEAR(last.value, 10.0, 1e-12);
    EXPECT_NEAR(last.speed, 0.0, 1e-10);
    EXPECT_NEAR(last.acceleration, 0.0, 1e-9);
    // Speed and acceleration are what the value does.
    constexpr double kStep = 1e-4;
    const Travelling before = travelled(start, 10.0, 0.3 - kStep, 0.8);
    const Travelling here = travelled(start, 10.0, 0.3, 0.8);
    const Travelling after = travelled(start, 10.0, 0.3 + kStep, 0.8);
    EXPECT_NEAR(here.speed, (after.value - before.value) / (2.0 * kStep * 0.8), 1e-5);
    EXPECT_NEAR(here.acceleration, (after.speed - before.speed) / (2.0 * kStep * 0.8), 1e-4);
}

TEST(Travelling, NeverSwingsPastItsGoalFromRest) {
    double before = 0.0;
    for (int i = 0; i <= 100; ++i) {
        const double now = travelled({}, 1.0, 0.01 * i, 1.1).value;
        EXPECT_GE(now, before);
        EXPECT_LE(now, 1.0 + 1e-12);
        before = now;
    }
    EXPECT_NEAR(travelled({}, 1.0, 0.5, 1.1).value, 0.5, 1e-12) << "half of the way in half of the time";
}

TEST(CameraMotion, EndsExactlyAtItsGoalInLittleMoreThanASecond) {
    for (const double rate_hz : {24.0, 60.0, 144.0}) {
        CameraMotion motion;
        motion.jump_to(kThrowing);
        EXPECT_TRUE(motion.at_rest());
        motion.go_to(kLookingIn);
        EXPECT_FALSE(motion.at_rest());
        double taken_s = 0.0;
        while (!motion.at_rest() && taken_s < 10.0) {
            motion.advance(1.0 / rate_hz);
            taken_s += 1.0 / rate_hz;
        }
        EXPECT_EQ(motion.pose(), kLookingIn);
        EXPECT_NEAR(taken_s, 1.1 + 0.5 / rate_hz, 0.6 / rate_hz);
    }
}

TEST(CameraMotion, IsWhereItWouldBeAtAnyFrameRate) {
    const auto after_half_a_second = [](double rate_hz) {
        CameraMotion motion;
        motion.jump_to(kThrowing);
        motion.go_to(kLookingIn);
        for (int i = 0; i < static_cast<int>(0.5 * rate_hz); ++i)
            motion.advance(1.0 / rate_hz);
        return motion.pose();
    };
    const CameraPose slow = after_half_a_second(24.0);
    const CameraPose quick = after_half_a_second(240.0);
    EXPECT_NEAR(slow.up_mm, quick.up_mm, 1e-6);
    EXPECT_NEAR(slow.vertical_fov_rad, quick.vertical_fov_rad, 1e-9);
}

TEST(CameraMotion, KeepsItsSpeedWhenItIsCalledBack) {
    CameraMotion motion;
    motion.jump_to(kThrowing);
    motion.go_to(kLookingIn);
    for (int i = 0; i < 20; ++i)
        motion.advance(1.0 / 60.0);
    const double before = motion.pose().up_mm;
    motion.go_to(kThrowing);
    motion.advance(1.0 / 240.0);
    EXPECT_GT(motion.pose().up_mm, before) << "it turned on the spot";
    for (int i = 0; i < 300; ++i)
        motion.advance(1.0 / 60.0);
    EXPECT_EQ(motion.pose(), kThrowing);
}

TEST(CameraMotion, TakesTheShortWayRound) {
    CameraPose left = kThrowing;
    left.azimuth_rad = 3.0;
    CameraPose right = kThrowing;
    right.azimuth_rad = -3.0;
    CameraMotion motion;
    motion.jump_to(left);
    motion.go_to(right);
    for (int i = 0; i < 30; ++i) {
        motion.advance(1.0 / 60.0);
        const double from_back =
            std::abs(std::remainder(motion.pose().azimuth_rad - std::numbers::pi, 2.0 * std::numbers::pi));
        EXPECT_LT(from_back, 0.2);
    }
}

TEST(CameraPose, IsTheCameraItCameFrom) {
    const render::Camera camera{
        .eye_mm = {110.0F, 370.0F, 1115.0F}, .target_mm = {0.0F, 130.0F, 0.0F}, .vertical_fov_rad = 0.6283F};
    const render::Camera back = camera_at(pose_of(camera));
    EXPECT_NEAR(glm::length(back.eye_mm - camera.eye_mm), 0.0F, 1e-3F);
    EXPECT_EQ(back.target_mm, camera.target_mm);
    EXPECT_EQ(back.vertical_fov_rad, camera.vertical_fov_rad);
}

TEST(ShareOfATransition, ShowsOneBackgroundAloneNearEachEnd) {
    EXPECT_EQ(fraction_between(kThrowing, kLookingIn, kThrowing), 0.0);
    EXPECT_EQ(fraction_between(kThrowing, kLookingIn, kLookingIn), 1.0);
    CameraPose halfway = kThrowing;
    halfway.out_mm = 0.5 * (kThrowing.out_mm + kLookingIn.out_mm);
    halfway.up_mm = 0.5 * (kThrowing.up_mm + kLookingIn.up_mm);
    EXPECT_NEAR(fraction_between(kThrowing, kLookingIn, halfway), 0.5, 1e-9);
    EXPECT_EQ(fraction_between(kThrowing, kThrowing, kLookingIn), 0.0);
}

}  // namespace
}  // namespace onggi::wheel

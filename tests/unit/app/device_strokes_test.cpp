// The strokes of a device, on a virtual clock.
#include "game/app/kiosk/finger/device_strokes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace onggi::app {
namespace {

class DeviceStrokesTest : public testing::Test {
  protected:
    using Strokes = std::vector<Stroke>;

    static constexpr double kFrameS = 1.0 / 60.0;
    void look(const std::optional<dvec3>& tip_mm) {
        const Stroke stroke = strokes.look(tip_mm, kFrameS);
        if (stroke != Stroke::kNone) seen.push_back(stroke);
    }
    void rest(double seconds = 0.3) {
        for (double s = 0.0; s < seconds; s += kFrameS)
            look(at_mm);
    }
    void go(const dvec3& by_mm, double speed_mm_s = 150.0) {
        const double length_mm = glm::length(by_mm);
        const dvec3 from_mm = at_mm;
        for (double s_mm = 0.0; s_mm < length_mm; s_mm += speed_mm_s * kFrameS)
            look(from_mm + by_mm * (s_mm / length_mm));
        at_mm = from_mm + by_mm;
        look(at_mm);
    }
    void stroke(const dvec3& by_mm) {
        go(by_mm);
        go(-by_mm);
        rest();
    }
    Strokes take() { return std::exchange(seen, {}); }

    DeviceStrokes strokes;
    dvec3 at_mm{120.0, 200.0, 30.0};
    Strokes seen;
};

TEST_F(DeviceStrokesTest, CountOnceEachInFourDirections) {
    rest(1.0);
    stroke({50.0, 4.0, -3.0});
    stroke({-50.0, 0.0, 0.0});
    stroke({0.0, 50.0, 0.0});
    stroke({5.0, 0.0, -50.0});
    stroke({0.0, 0.0, 50.0});
    stroke({0.0, -50.0, 0.0});
    EXPECT_EQ(take(), (Strokes{Stroke::kRight, Stroke::kLeft, Stroke::kPress, Stroke::kPress, Stroke::kAsk}))
        << "down stands for nothing";
}

TEST_F(DeviceStrokesTest, HandMayHoldStillAtTheEndOfAStrokeAndComeBackElsewhere) {
    rest(1.0);
    go({60.0, 0.0, 0.0});
    rest(5.0);
    EXPECT_EQ(take(), Strokes{Stroke::kRight}) << "held";
    go({-85.0, 0.0, 0.0});
    rest(1.0);
    EXPECT_EQ(take(), Strokes{}) << "the way back is no stroke";
    stroke({50.0, 0.0, 0.0});
    EXPECT_EQ(take(), Strokes{Stroke::kRight}) << "from where the hand rests now";
    go({0.0, 50.0, 0.0});
    rest(1.0);
    stroke({50.0, 0.0, 0.0});
    stroke({-50.0, 0.0, 0.0});
    EXPECT_EQ(take(), (Strokes{Stroke::kPress, Stroke::kRight, Stroke::kLeft})) << "without a way back";
    for (int i = 0; i < 2; ++i) {
        go({32.0, 0.0, 0.0});
        rest(1.0);
    }
    EXPECT_EQ(take(), (Strokes{Stroke::kRight, Stroke::kRight})) << "onwards";
    go({-28.0, 0.0, 0.0});
    rest(1.0);
    stroke({-50.0, 0.0, 0.0});
    EXPECT_EQ(take(), Strokes{Stroke::kLeft}) << "a short way back is one, too";
}

TEST_F(DeviceStrokesTest, SlowHandMakesOneOfEachWhetherItTremblesOrNot) {
    constexpr double kSlowMmS = 20.0;
    const auto goes = [&](const dvec3& by_mm, double tremor_mm) {
        const dvec3 from_mm = at_mm;
        constexpr double kTremorHz = 5.0;
        const double seconds = glm::length(by_mm) / kSlowMmS;
        for (double s = 0.0; s < seconds; s += kFrameS)
            look(from_mm + by_mm * (s / seconds) +
                 dvec3(tremor_mm * std::sin(2.0 * kPi * kTremorHz * s), 0.0, 0.0));
        at_mm = from_mm + by_mm;
    };
    rest(1.0);
    for (const double tremor_mm : {0.0, 3.0}) {
        for (const dvec3& way_mm : {dvec3(45.0, 0.0, 0.0), dvec3(45.0, 0.0, 0.0), dvec3(0.0, 45.0, 0.0)}) {
            goes(way_mm, tremor_mm);
            goes(-way_mm, tremor_mm);
            rest(1.0);
        }
        EXPECT_EQ(take(), (Strokes{Stroke::kRight, Stroke::kRight, Stroke::kPress})) << tremor_mm;
    }
}

TEST_F(DeviceStrokesTest, HandThatComesOrTremblesMakesNone) {
    go({0.0, 120.0, 0.0});
    rest(1.0);
    EXPECT_EQ(take(), Strokes{}) << "the way to the buttons";
    for (int i = 0; i < 40; ++i)
        go({i % 2 == 0 ? 8.0 : -8.0, 0.0, 0.0});
    EXPECT_EQ(take(), Strokes{});
    look(std::nullopt);
    go({90.0, 0.0, 0.0});
    EXPECT_EQ(take(), Strokes{}) << "nothing is known of a hand that was at work";
}

}  // namespace
}  // namespace onggi::app

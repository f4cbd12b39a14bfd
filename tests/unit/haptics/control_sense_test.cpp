// A person at a control, and a control that moves by itself, on a virtual clock.
#include "engine/haptics/control_sense.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace onggi::haptics {
namespace {

constexpr double kSampleS = 0.01;

// A control whose noise is 1, and how often it gave a sign of life.
struct Control {
    ControlSense sense{1.0};
    int signs = 0;

    bool says(const dvec3& value, double dt_s = kSampleS, bool is_held = false) {
        const bool lives = sense.moved_to(value, dt_s, is_held);
        signs += lives ? 1 : 0;
        return lives;
    }
    // For so long, the value by the time since then.
    template <typename Value>
    int signs_during(double seconds, const Value& value, bool is_held = false) {
        signs = 0;
        const int steps = static_cast<int>(seconds / kSampleS + 0.5);
        for (int step = 1; step <= steps; ++step)
            says({value(step * kSampleS), 0.0, 0.0}, kSampleS, is_held);
        return signs;
    }
};

TEST(ControlSense, TellsSlowWorkFromATremble) {
    Control hand;
    EXPECT_FALSE(hand.says({500.0, 0.0, 0.0})) << "the first place is no motion";
    for (int turn = 0; turn < 100; ++turn)
        EXPECT_FALSE(hand.says({500.0 + 0.9 * (turn % 2), 0.0, 0.0}));
    hand.signs = 0;
    for (int step = 0; step < 1000; ++step)
        hand.says({500.0 + 0.01 * step, 0.0, 0.0});
    EXPECT_EQ(hand.signs, 9) << "10 mm in ten seconds";
}

TEST(ControlSense, IsStillWhereItIsHeldOrDrifts) {
    Control leaning;
    EXPECT_EQ(leaning.signs_during(3600.0, [](double) { return 16.0; }), 0);
    EXPECT_GE(leaning.sense.still_s(), 3599.0);
    EXPECT_FALSE(leaning.sense.never_rests());
    Control drifting;
    EXPECT_EQ(drifting.signs_during(3600.0, [](double at_s) { return 0.04 * at_s; }), 0)
        << "as a sensor that warms up";
    EXPECT_TRUE(drifting.says({160.0, 0.0, 0.0})) << "a hand";
}

TEST(ControlSense, NamesWhatIsHeldForTenMinutes) {
    Control pedal;
    EXPECT_EQ(pedal.signs_during(
                  599.0, [](double) { return 16.0; }, true),
              0);
    EXPECT_FALSE(pedal.sense.never_rests());
    pedal.signs_during(
        2.0, [](double) { return 16.0; }, true);
    EXPECT_TRUE(pedal.sense.never_rests());
    pedal.says({0.0, 0.0, 0.0});
    EXPECT_FALSE(pedal.sense.never_rests()) << "it is let go";
}

// Beyond its noise all the time.
class ANoisyControl : public testing::Test {
  protected:
    double noise() { return 4.0 * std::uniform_real_distribution(-1.0, 1.0)(chance_); }
    int signs_during(double seconds) {
        return control_.signs_during(seconds, [&](double) { return noise(); });
    }

    std::mt19937 chance_{46};
    Control control_;
};

TEST_F(ANoisyControl, CountsForTenMinutesAndThenNoMore) {
    EXPECT_GT(signs_during(590.0), 1000);
    EXPECT_FALSE(control_.sense.never_rests());
    signs_during(11.0);
    EXPECT_TRUE(control_.sense.never_rests());
    EXPECT_EQ(signs_during(3600.0), 0);
}

TEST_F(ANoisyControl, CountsAgainWhereAPersonMovesItOrItHasRested) {
    signs_during(700.0);
    ASSERT_TRUE(control_.sense.never_rests());
    EXPECT_FALSE(control_.says({6.0, 0.0, 0.0})) << "its noise may grow a little";
    EXPECT_GT(control_.signs_during(20.0, [&](double at_s) { return 2.0 * at_s + noise(); }), 100);
    EXPECT_EQ(signs_during(300.0), 0) << "the person has gone";
    EXPECT_TRUE(control_.sense.never_rests());
    control_.signs_during(61.0, [](double) { return 1.0; });
    EXPECT_FALSE(control_.sense.never_rests()) << "somebody has mended it";
    EXPECT_TRUE(control_.says({3.0, 0.0, 0.0}));
}

TEST_F(ANoisyControl, IsLearntAnewWhereItsNoiseHasGrown) {
    signs_during(700.0);
    const auto louder = [&](double) { return 10.0 * noise(); };
    EXPECT_GT(control_.signs_during(500.0, louder), 1000);
    control_.signs_during(160.0, louder);
    EXPECT_EQ(control_.signs_during(600.0, louder), 0);
    EXPECT_EQ(signs_during(300.0), 0);
    EXPECT_TRUE(control_.says({15.0, 0.0, 0.0})) << "and where it has shrunk";
}

TEST_F(ANoisyControl, OfAPlaceThatPeopleUseInTurnIsThemWhereItGoesAbout) {
    control_.sense = ControlSense(1.0, 5.0);
    signs_during(3600.0);
    EXPECT_FALSE(control_.sense.never_rests());
    EXPECT_GT(control_.signs, 1000);
}

TEST(ControlSense, TakesAnEventForAChangeAndTheSameOverAndOverForWear) {
    ControlSense spot(24.0, 24.0);
    const dvec3 place(100.0, 40.0, 0.0);
    EXPECT_TRUE(spot.struck_at(place)) << "also the first";
    for (int second = 0; second < 597; second += 3) {
        spot.pass(3.0);
        EXPECT_TRUE(spot.struck_at(place)) << second;
    }
    spot.pass(3.0);
    EXPECT_FALSE(spot.struck_at(place));
    EXPECT_TRUE(spot.never_rests());
    EXPECT_TRUE(spot.struck_at({300.0, 40.0, 0.0})) << "a finger elsewhere";
    EXPECT_FALSE(spot.struck_at(place));
    spot.pass(61.0);
    EXPECT_TRUE(spot.struck_at(place)) << "it was dry for a minute";
    EXPECT_FALSE(spot.never_rests());
}

TEST(ControlSense, IgnoresWhatIsNoNumber) {
    Control control;
    control.says({1.0, 0.0, 0.0});
    EXPECT_FALSE(control.says({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}));
    EXPECT_FALSE(control.says({std::numeric_limits<double>::infinity(), 0.0, 0.0}));
    EXPECT_FALSE(control.says({1.5, 0.0, 0.0}));
    EXPECT_TRUE(control.says({3.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace onggi::haptics

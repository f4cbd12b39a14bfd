// One finger and the simulated hands that follow it: what the clay guarantees for any touch.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "game/clay/studio/pot.h"
#include "game/clay/studio/spare_clay.h"
#include "tests/studio/bench.h"
#include "tests/studio/finger.h"

namespace onggi::clay::studio {
namespace {

TEST(Grips, OpenSolidClayWhereverNearItsMiddleTheFingerComesDown) {
    for (const double x : {0.0, 0.3, 2.0, 5.0, 9.0, -5.0, 15.0}) {
        Finger finger;
        finger.stroke({x, finger.clay.height_mm() + 3.0}, {x, 8.0}, 2.0);
        EXPECT_NEAR(finger.clay.floor_mm(), 11.0, 2.0) << "at " << x;
        EXPECT_GT(finger.clay.height_mm(), 45.0) << "at " << x;
    }
}

TEST(Grips, OpenByThemselvesUnderAFingerThatLiesStill) {
    Finger finger;
    finger.stroke({0.0, finger.clay.height_mm()}, {0.0, finger.clay.height_mm() - 1.0}, 3.5);
    EXPECT_LT(finger.clay.floor_mm(), 14.0);
}

TEST(Grips, RaiseNoChimneyUnderAFingerThatLiesStillOnAWall) {
    Finger finger;
    finger.open();
    const double before = finger.clay.height_mm();
    finger.stroke({finger.clay.outer_mm()[100] - 3.0, 20.0}, {finger.clay.outer_mm()[100] - 3.5, 20.5}, 5.0);
    EXPECT_NEAR(finger.clay.height_mm(), before, 6.0) << "four millimetres are pressed in, and no more";
}

TEST(Grips, TakeTheRimToWhereThePullEndsAndNoFurther) {
    Finger finger;
    finger.open();
    finger.pull(95.0);
    EXPECT_NEAR(finger.clay.height_mm(), 95.0, 5.0);
    EXPECT_LE(finger.clay.height_mm(), 96.0);
}

TEST(Grips, CarryTheWallToTheFingerAndNeverPastIt) {
    Finger finger;
    finger.open();
    finger.pull(100.0);
    const auto radius = [&](double y) {
        return finger.clay.rings().outer_mm[Rings::at(finger.clay.rings().ring_at(y))];
    };
    const double from = radius(60.0);
    finger.stroke({from, 60.0}, {from + 14.0, 62.0}, 1.5);
    EXPECT_GT(radius(62.0), from + 8.0);
    EXPECT_LE(radius(62.0), from + 14.5);
    EXPECT_NEAR(finger.clay.height_mm(), 100.0, 6.0) << "moving to the side changes no height";
}

TEST(Grips, LetGoInTheTickInWhichTheFingerLifts) {
    Finger finger;
    finger.open();
    finger.pull(100.0);
    const std::vector<double> before = finger.faces();
    // Over the clay, through it and away, as a hand does on its way to a button.
    finger.input.pressing = false;
    for (int i = 0; i < 3000; ++i) {
        finger.input.position_mm = {150.0 - 0.1 * i, 120.0 - 0.05 * i, 0.0};
        finger.tick();
        EXPECT_EQ(finger.forces.hand.contacts, 0);
    }
    EXPECT_EQ(finger.faces(), before);
}

TEST(Grips, LeaveTheSameBitsWhenResumedInTheMiddleOfATouch) {
    Finger finger;
    finger.open();
    finger.input.pressing = true;
    for (int i = 0; i < 777; ++i) {
        finger.input.position_mm = {60.0 + 0.01 * i, 20.0 + 0.08 * i, 0.0};
        finger.tick();
    }
    auto copy = StudioClay::from_start_state(finger.clay.start_state());
    ASSERT_TRUE(copy) << copy.error().message;
    for (int i = 0; i < 500; ++i) {
        finger.input.position_mm.y += 0.05;
        finger.tick();
        copy->tick(finger.input, finger.parameters);
    }
    EXPECT_EQ(copy->state_hash(), finger.clay.state_hash());
}

// Beside the wall at that height: outside it, and inside as far away as two fingers on a screen are.
struct Beside {
    explicit Beside(const Finger& finger, double y)
        : outside(face(finger, y) + 2.0, y),
          inside(face(finger, y) - 24.0, y) {}
    static double face(const Finger& finger, double y) { return outer_face_mm(finger.clay.rings(), y); }
    dvec2 outside;
    dvec2 inside;
};

// A pull of six seconds up to 225 mm, by one finger or by two.
Finger pulled(bool by_two) {
    Finger finger;
    finger.open();
    const Beside at(finger, 0.3 * finger.clay.height_mm());
    const dvec2 up{0.0, 225.0 - at.outside.y};
    const auto second = by_two ? FingerWay{at.inside, at.inside + up, true} : FingerWay{};
    finger.move(at.outside, at.outside + up, 6.0, second);
    finger.lift();
    return finger;
}

double mean_wall_mm(const Rings& rings) {
    double walls = 0.0;
    double height = 0.0;
    for (int i = rings.first_hollow; i < rings.count; ++i) {
        walls += rings.height_mm[Rings::at(i)] * rings.wall_mm(i);
        height += rings.height_mm[Rings::at(i)];
    }
    return walls / height;
}

TEST(TwoFingers, ThinAndRaiseAWallMoreThanOneAndLeaveSomeForTheNextPull) {
    const Finger one = pulled(false);
    const Finger two = pulled(true);
    EXPECT_GT(two.clay.height_mm(), one.clay.height_mm() + 4.0);
    EXPECT_LT(mean_wall_mm(two.clay.rings()), mean_wall_mm(one.clay.rings()) - 0.2);
    EXPECT_GT(spare_rise(two.clay.rings()), 8.0);
}

TEST(TwoFingers, SqueezeTheWallWhereTheyComeCloser) {
    Finger finger;
    finger.open();
    finger.pull(100.0);
    const Beside at(finger, 50.0);
    const auto wall = [&] { return finger.clay.rings().wall_mm(finger.clay.rings().ring_at(50.0)); };
    const double before = wall();
    finger.move(at.outside, at.outside, 1.0, FingerWay{at.inside, at.inside, true});
    EXPECT_NEAR(wall(), before, 0.3) << "they only hold it";
    finger.move(at.outside, at.outside, 2.0, FingerWay{at.inside, at.inside + dvec2(3.0, 0.0), true});
    EXPECT_LT(wall(), before - 1.0);
    EXPECT_GT(wall(), before - 3.5);
}

TEST(TwoFingers, CollarAPotFromBothSides) {
    const auto neck = [](bool first_moves, bool has_second) {
        Finger finger;
        finger.open();
        finger.pull(100.0);
        const double r = outer_face_mm(finger.clay.rings(), 85.0);
        const double to = first_moves ? r - 8.0 : r;
        const auto second = has_second ? FingerWay{{-r, 85.0}, {-r + 8.0, 85.0}, true} : FingerWay{};
        finger.move({r, 85.0}, {to, 85.0}, 2.0, second);
        return r - outer_face_mm(finger.clay.rings(), 85.0);
    };
    EXPECT_GT(neck(false, true), 5.0) << "a hand that only rests does not hold against the other";
    EXPECT_GE(neck(true, true), neck(true, false) - 0.5) << "the second adds to the first";
}

TEST(TwoFingers, GoOnWithoutAJumpWhereTheSecondLifts) {
    for (const bool is_inside : {true, false}) {
        Finger finger;
        finger.open();
        finger.pull(100.0);
        const Beside at(finger, 60.0);
        const dvec2 other = is_inside ? at.inside : dvec2(-at.outside.x, 60.0);
        const double way = is_inside ? 6.0 : 8.0;
        finger.move(at.outside, at.outside, 2.0, FingerWay{other, other + dvec2(way, 0.0), true});
        const std::vector<double> before = finger.faces();
        const double height = finger.clay.height_mm();
        finger.move(at.outside, at.outside, 0.4);
        EXPECT_NEAR(finger.clay.height_mm(), height, 0.5);
        const std::vector<double> after = finger.faces();
        if (before.size() != after.size()) continue;  // rings were split or joined
        for (std::size_t i = 0; i < before.size(); ++i)
            EXPECT_NEAR(after[i], before[i], 0.6) << i;
    }
}

TEST(TwoFingers, ChangeNothingWhereTheSecondIsAwayFromTheClay) {
    Finger one;
    Finger two;
    for (Finger* finger : {&one, &two}) {
        finger->open();
        const auto away = finger == &two ? FingerWay{{190.0, 20.0}, {200.0, 30.0}, true} : FingerWay{};
        finger->move({60.0, 20.0}, {60.0, 90.0}, 2.0, away);
    }
    EXPECT_EQ(one.clay.state_hash(), two.clay.state_hash());
}

TEST(TwoFingers, LeaveTheSameBitsWhenResumedWhileBothHold) {
    Finger finger;
    finger.open();
    const Beside at(finger, 30.0);
    finger.move(at.outside, at.outside + dvec2(0.0, 20.0), 0.7,
                FingerWay{at.inside, at.inside + dvec2(2.0, 18.0), true});
    ASSERT_TRUE(finger.forces.grip.has_second && finger.forces.grip.second_is_inside);
    auto copy = StudioClay::from_start_state(finger.clay.start_state());
    ASSERT_TRUE(copy) << copy.error().message;
    EXPECT_EQ(copy->state_hash(), finger.clay.state_hash());
    for (int i = 0; i < 500; ++i) {
        finger.input.position_mm.y += 0.05;
        finger.tick();
        copy->tick(finger.input, finger.parameters);
    }
    EXPECT_EQ(copy->state_hash(), finger.clay.state_hash());
}

TEST(Grips, FollowTheirFingerAsFastAsItPushes) {
    const auto moved = [](double push) {
        Finger finger;
        finger.open();
        finger.pull(100.0);
        finger.push = push;
        const double from = outer_face_mm(finger.clay.rings(), 60.0);
        finger.move({from, 60.0}, {from - 12.0, 60.0}, 0.3);
        return from - outer_face_mm(finger.clay.rings(), 60.0);
    };
    EXPECT_LT(moved(0.1), 0.3 * moved(1.0)) << "a pen that hardly presses hardly moves the wall";
    EXPECT_GT(moved(1.6), moved(1.0) + 0.5);
}

TEST(Grips, ThrowTheSamePotAtEveryRate) {
    const auto thrown = [](double rate_hz) {
        Finger finger(rate_hz);
        finger.stroke({64.0, 15.0}, {52.0, 15.0}, 1.5);
        finger.wait(0.2);
        finger.open();
        finger.wait(0.2);
        finger.pull(110.0);
        return finger.clay;
    };
    const StudioClay slow = thrown(1000.0);
    const StudioClay fast = thrown(4000.0);
    EXPECT_NEAR(slow.height_mm(), fast.height_mm(), 1.0);
    for (double y = 5.0; y < 100.0; y += 5.0) {
        const double a = slow.rings().outer_mm[Rings::at(slow.rings().ring_at(y))];
        const double b = fast.rings().outer_mm[Rings::at(fast.rings().ring_at(y))];
        EXPECT_NEAR(a, b, 0.8) << "at " << y;
    }
}

TEST(Grips, KeepTheClayValidForAnyFinger) {
    std::mt19937_64 random(11);
    const auto uniform = [&](double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(random);
    };
    for (const double mass_g : {100.0, 500.0, 1000.0, 5000.0}) {
        Finger finger(1000.0, mass_g);
        for (int i = 0; i < 25000; ++i) {
            if (i % 40 == 0) finger.input.pressing = random() % 8 != 0;
            if (i % 25 == 0)
                finger.input.position_mm = {uniform(-200.0, 200.0), uniform(-50.0, 300.0),
                                            tool::z_of_push(finger.push)};
            if (i % 60 == 0) finger.input.second.present = random() % 3 != 0;
            if (i % 35 == 0)
                finger.input.second.position_mm = {uniform(-200.0, 200.0), uniform(-50.0, 300.0), 0.0};
            if (i % 200 == 0) finger.push = uniform(0.1, 2.0);
            if (i % 997 == 0) finger.input.position_mm.x = std::numeric_limits<double>::quiet_NaN();
            if (i % 5000 == 0) finger.pedal(uniform(0.0, 20.0));
            finger.tick();
        }
        const Rings& rings = finger.clay.rings();
        for (int i = 0; i < rings.count; ++i) {
            ASSERT_GT(rings.wall_mm(i), 0.0) << mass_g << " g, ring " << i;
            ASSERT_GT(rings.volume_mm3[Rings::at(i)], 0.0);
            ASSERT_TRUE(std::isfinite(rings.height_mm[Rings::at(i)]));
        }
        EXPECT_EQ(finger.clay.ledger_error_mm3(), 0.0);
        EXPECT_TRUE(StudioClay::from_start_state(finger.clay.start_state())) << mass_g;
    }
}

TEST(Grips, DentAWheelThatStands) {
    Finger finger;
    finger.open();
    finger.pedal(0.0);
    finger.wait(6.0);
    ASSERT_LT(finger.clay.wheel().speed_rad_s(), 0.2);
    const std::vector<double> before = finger.faces();
    const double wall = finger.clay.outer_mm()[200];
    finger.stroke({wall - 4.0, 25.0}, {wall - 4.0, 25.0}, 1.0);
    bool is_dented = false;
    for (int i = 0; i < finger.clay.ring_count(); ++i)
        is_dented = is_dented || !finger.clay.residuals_mm(i).empty();
    EXPECT_TRUE(is_dented);
}

}  // namespace
}  // namespace onggi::clay::studio

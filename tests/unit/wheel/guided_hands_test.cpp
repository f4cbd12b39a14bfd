// The drawn hands of a finger: at the clay, or beside it in the pose of the next touch.

#include <gtest/gtest.h>

#include <cmath>

#include "game/wheel/hands.h"
#include "tests/support/millimetre_pot.h"

namespace onggi::wheel {
namespace {

using clay::studio::Grip;
using tool::Side;
using Hands = std::array<DrawnHand, 2>;

// A cylinder of millimetre rings, hollow above floor_mm.
pot::Pot pot(double height_mm, double outer_mm, double wall_mm, double floor_mm) {
    return test::millimetre_pot(height_mm, outer_mm, floor_mm, outer_mm - wall_mm);
}

class GuidedHands : public ::testing::Test {
  protected:
    GuidedHands() {
        snapshot_.tool.guided = true;
        snapshot_.tool.radius_mm = 12.0;
    }
    Hands hovers(const pot::Pot& shape, const dvec2& finger_mm) {
        snapshot_.pot = &shape;
        snapshot_.tool.pressing = false;
        snapshot_.tool.position_mm = dvec3(finger_mm, 0.0);
        snapshot_.result.grip = {.finger_mm = finger_mm};
        return hands_of(snapshot_);
    }
    Hands works(const pot::Pot& shape, Grip grip, const dvec2& hand_mm) {
        snapshot_.pot = &shape;
        snapshot_.tool.pressing = true;
        snapshot_.tool.position_mm = {0.0, 200.0, 0.0};  // far off: the hands are not there
        snapshot_.result.grip = {.grip = grip, .hand_mm = hand_mm};
        return hands_of(snapshot_);
    }
    // The place at which a hand touches.
    static dvec3 touch_of(const DrawnHand& hand) {
        const double out = std::copysign(1.0, hand.position_mm.x);
        switch (hand.side) {
            case Side::kTop:
                return hand.position_mm - dvec3(0.0, hand.radius_mm, 0.0);
            case Side::kIn:
                return hand.position_mm + dvec3(out * hand.radius_mm, 0.0, 0.0);
            default:
                return hand.position_mm - dvec3(out * hand.radius_mm, 0.0, 0.0);
        }
    }

    const pot::Pot lump_ = pot(50, 62, 62, 50);
    const pot::Pot cup_ = pot(100, 60, 8, 11);
    haptic::Snapshot snapshot_;
};

TEST_F(GuidedHands, AreTwoFingersEachWhereItsFingerIs) {
    const auto works_with = [&](Grip grip, bool is_inside, const dvec2& second_mm) {
        snapshot_.pot = &cup_;
        snapshot_.tool.pressing = true;
        snapshot_.result.grip = {.grip = grip,
                                 .hand_mm = {62.0, 50.0},
                                 .has_second = true,
                                 .second_is_inside = is_inside,
                                 .second_mm = second_mm};
        return hands_of(snapshot_);
    };
    Hands hands = works_with(Grip::kWall, true, {40.0, 70.0});
    EXPECT_EQ(hands[1].side, Side::kIn);
    EXPECT_NEAR(glm::distance(touch_of(hands[1]), dvec3(52.0, 70.0, 0.0)), 0.0, 0.5);
    hands = works_with(Grip::kWall, false, {-66.0, 30.0});
    EXPECT_EQ(hands[1].side, Side::kOut);
    EXPECT_NEAR(glm::distance(touch_of(hands[1]), dvec3(-60.0, 30.0, 0.0)), 0.0, 0.5);
    EXPECT_EQ(hands[0].side, Side::kOut);
    EXPECT_GT(touch_of(hands[0]).x, 0.0);
    hands = works_with(Grip::kInside, false, {66.0, 80.0});
    EXPECT_EQ(hands[1].side, Side::kIn) << "the first one stays inside";
    EXPECT_NEAR(glm::distance(touch_of(hands[0]), dvec3(60.0, 80.0, 0.0)), 0.0, 0.5);
}

TEST_F(GuidedHands, HoldTheWallFromBothSides) {
    for (const double side : {1.0, -1.0}) {
        const Hands view = works(cup_, Grip::kWall, {side * 20.0, 40.0});
        EXPECT_EQ(view[0].side, Side::kOut);
        EXPECT_LT(glm::length(touch_of(view[0]) - dvec3(side * 60.0, 40.0, 0.0)), 1e-6) << "on the clay";
        ASSERT_TRUE(view[1].shown);
        EXPECT_EQ(view[1].side, Side::kIn);
        EXPECT_LT(glm::length(touch_of(view[1]) - dvec3(side * 52.0, 40.0, 0.0)), 1e-6);
        EXPECT_TRUE(view[0].guided && view[0].touching && !view[0].digs);
    }
    const Hands low = works(cup_, Grip::kWall, {60.0, -5.0});
    EXPECT_GT(low[0].position_mm.y, 10.0) << "above the wheel";
    EXPECT_GT(low[1].position_mm.y, 11.0) << "above the floor";
    const Hands high = works(cup_, Grip::kWall, {60.0, 101.5});
    EXPECT_LT(high[0].position_mm.y, 100.0) << "finger tips at the rim";
    EXPECT_NEAR(high[0].position_mm.y, high[1].position_mm.y, 1e-9);
}

TEST_F(GuidedHands, HoldALumpBetweenTwoPalms) {
    const Hands view = works(lump_, Grip::kWall, {62.0, 20.0});
    ASSERT_TRUE(view[1].shown);
    EXPECT_EQ(view[1].side, Side::kOut);
    EXPECT_EQ(touch_of(view[0]).x, 62.0);
    EXPECT_EQ(touch_of(view[1]).x, -62.0);
}

TEST_F(GuidedHands, OpenInTheMiddleReachInsideAndPressTheRim) {
    const Hands opens = works(lump_, Grip::kOpen, {5.0, 30.0});
    EXPECT_TRUE(opens[0].digs);
    EXPECT_EQ(opens[0].side, Side::kTop);
    EXPECT_EQ(touch_of(opens[0]).x, 5.0);
    EXPECT_LT(touch_of(opens[0]).y, 30.0);
    EXPECT_FALSE(opens[1].shown);

    const Hands inside = works(cup_, Grip::kInside, {52.0, 60.0});
    EXPECT_EQ(inside[1].side, Side::kIn);
    EXPECT_EQ(touch_of(inside[1]), dvec3(52.0, 60.0, 0.0));
    EXPECT_EQ(inside[0].side, Side::kOut);
    EXPECT_EQ(touch_of(inside[0]), dvec3(60.0, 60.0, 0.0));

    const Hands rim = works(cup_, Grip::kRim, {58.0, 100.0});
    EXPECT_EQ(rim[0].side, Side::kTop);
    EXPECT_FALSE(rim[0].digs);
    EXPECT_EQ(touch_of(rim[0]), dvec3(56.0, 100.0, 0.0));
}

TEST_F(GuidedHands, ReachBehindAShoulderWithNoArmThroughIt) {
    pot::Pot jar = pot(120, 70, 8, 11);
    for (int i = 80; i < jar.ring_count(); ++i)
        jar.inner_mm[static_cast<std::size_t>(i)] = 40.0F;
    for (const Grip grip : {Grip::kWall, Grip::kInside}) {
        for (double y = 15.0; y < 118.0; y += 3.0) {
            const dvec3 tips = touch_of(works(jar, grip, {70.0, y})[1]);
            EXPECT_LE(tips.x, wall_at(jar, tips.y).inner_mm);
            // An arm from there to the mouth, leaning in by a quarter.
            for (double up = tips.y; up < 119.5; up += 1.0)
                EXPECT_LE(tips.x - 0.25 * (up - tips.y), wall_at(jar, up).inner_mm + 0.3) << y << ", " << up;
        }
    }
    EXPECT_EQ(touch_of(works(cup_, Grip::kWall, {60.0, 40.0})[1]).x, 52.0) << "to the wall where it can";
}

TEST_F(GuidedHands, HoverInThePoseThatATouchWouldBegin) {
    for (const pot::Pot* shape : {&lump_, &cup_}) {
        for (double x = -130.0; x <= 130.0; x += 3.0) {
            for (double y = 0.0; y < 170.0; y += 3.0) {
                const Hands view = hovers(*shape, {x, y});
                for (const DrawnHand* hand : {&view[0], &view[1]}) {
                    if (!hand->shown) continue;
                    const dvec3 at = touch_of(*hand);
                    const double outer = wall_at(*shape, std::min(at.y, shape->height_mm - 0.5)).outer_mm;
                    EXPECT_TRUE(at.y >= shape->height_mm || std::abs(at.x) >= outer)
                        << "in the clay at " << x << ", " << y;
                    EXPECT_FALSE(hand->touching);
                }
                EXPECT_NE(view[0].shown, view[1].shown) << x << ", " << y;
            }
        }
    }
    EXPECT_TRUE(hovers(lump_, {0.0, 48.0})[0].digs);
    EXPECT_EQ(hovers(cup_, {58.0, 100.0})[0].side, Side::kTop);
    EXPECT_EQ(hovers(cup_, {10.0, 90.0})[1].side, Side::kIn);
    EXPECT_EQ(hovers(cup_, {-10.0, 30.0})[0].side, Side::kOut);
    EXPECT_LT(hovers(cup_, {-10.0, 30.0})[0].position_mm.x, -60.0);
}

TEST_F(GuidedHands, LieBesideEvenTheWidestPotWhenTheyRest) {
    const pot::Pot background = pot(40, 135, 8, 10);
    const Hands view = hovers(background, {230.0, 20.0});
    EXPECT_GE(touch_of(view[0]).x, 135.0);
    EXPECT_LE(hovers(cup_, {260.0, 45.0})[0].position_mm.x, 240.0) << "but in the picture";
}

TEST_F(GuidedHands, LeaveADeviceItsBall) {
    snapshot_.tool = {.position_mm = {70.0, 40.0, 20.0}, .radius_mm = 12.0};
    snapshot_.pot = &cup_;
    const Hands view = hands_of(snapshot_);
    EXPECT_EQ(view[0].position_mm, dvec3(70.0, 40.0, 20.0));
    EXPECT_FALSE(view[0].guided);
}

}  // namespace
}  // namespace onggi::wheel

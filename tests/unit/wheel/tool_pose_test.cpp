#include "game/wheel/tool_pose.h"

#include <gtest/gtest.h>

#include <cmath>

namespace onggi::wheel {
namespace {

using tool::Side;
using tool::Tool;

constexpr double kFrameS = 1.0 / 60.0;

// A hand at the right of a wall of radius 70 mm.
DrawnHand outside() {
    return {.position_mm = {80.0, 100.0, 0.0}, .radius_mm = 10.0, .side = Side::kOut, .touching = true};
}
DrawnHand inside(double mouth_radius_mm = 70.0) {
    return {.position_mm = {54.0, 100.0, 0.0},
            .radius_mm = 10.0,
            .side = Side::kIn,
            .touching = true,
            .mouth_radius_mm = mouth_radius_mm,
            .is_second = true};
}
ToolPose settled(const DrawnHand& hand) {
    ToolPose pose;
    pose.follow(hand, 0.0);
    return pose;
}
// The point where the model touches the clay, and its direction away from the clay.
vec3 touch_of(const ShownTool& tool) {
    return vec3(tool.place[3]);
}
vec3 way_out_of(const ShownTool& tool) {
    return vec3(tool.place[0]);
}

TEST(ToolPose, TouchesTheWallWhereTheBallDoes) {
    const ToolPicture out = settled(outside()).picture();
    ASSERT_EQ(out.tools.size(), 1U);
    EXPECT_EQ(out.tools[0].model, ToolModel::kHandOuter);
    EXPECT_LT(glm::distance(touch_of(out.tools[0]), vec3(70.0F, 100.0F, 0.0F)), 0.01F);
    EXPECT_GT(way_out_of(out.tools[0]).x, 0.99F);

    const ToolPicture in = settled(inside()).picture();
    ASSERT_EQ(in.tools.size(), 1U);
    EXPECT_EQ(in.tools[0].model, ToolModel::kHandInner);
    EXPECT_LT(glm::distance(touch_of(in.tools[0]), vec3(64.0F, 100.0F, 0.0F)), 0.01F);
    EXPECT_LT(way_out_of(in.tools[0]).x, -0.99F);
}

TEST(ToolPose, GivesEachSideOfThePotItsOwnHand) {
    DrawnHand left = outside();
    left.position_mm.x = -left.position_mm.x;
    EXPECT_FALSE(settled(outside()).picture().tools.at(0).left);
    EXPECT_TRUE(settled(left).picture().tools.at(0).left);
    EXPECT_TRUE(settled(inside()).picture().tools.at(0).left)
        << "the left hand presses to the right, from inside";
}

TEST(ToolPose, NeverHidesTheTouchedPlaceFromTheVisitor) {
    for (int degree = 0; degree < 360; degree += 5) {
        const double angle = degree * 3.14159265358979 / 180.0;
        DrawnHand hand = outside();
        hand.position_mm = {80.0 * std::cos(angle), 100.0, 80.0 * std::sin(angle)};
        const ToolPicture picture = settled(hand).picture();
        // The visitor looks along -Z: a tool that leads out of the clay mostly towards +Z would be in the
        // way.
        EXPECT_LT(way_out_of(picture.tools.at(0)).z, 0.45F) << degree;
    }
}

TEST(ToolPose, FollowsAStepWithinAFewFrames) {
    ToolPose pose = settled(outside());
    DrawnHand moved = outside();
    moved.position_mm.y += 20.0;
    pose.follow(moved, kFrameS);
    const float first = touch_of(pose.picture().tools.at(0)).y;
    EXPECT_GT(first, 110.0F) << "a hand that lags is not where it is felt";
    EXPECT_LT(first, 120.0F);
    for (int frame = 0; frame < 4; ++frame)
        pose.follow(moved, kFrameS);
    EXPECT_NEAR(touch_of(pose.picture().tools.at(0)).y, 120.0F, 0.2F);
}

TEST(ToolPose, EasesInTimeAndNotInFrames) {
    DrawnHand moved = outside();
    moved.wall_lean = 0.5;
    moved.position_mm.y += 9.0;
    ToolPose coarse = settled(outside());
    ToolPose fine = settled(outside());
    coarse.follow(moved, 0.1);
    for (int step = 0; step < 100; ++step)
        fine.follow(moved, 0.001);
    const mat4 a = coarse.picture().tools.at(0).place;
    const mat4 b = fine.picture().tools.at(0).place;
    for (int column = 0; column < 4; ++column)
        EXPECT_LT(glm::distance(a[column], b[column]), 1e-3F);
}

TEST(ToolPose, LeansWithTheWall) {
    DrawnHand hand = outside();
    hand.wall_lean = 0.4;  // wider above: the wall faces downwards
    EXPECT_LT(way_out_of(settled(hand).picture().tools.at(0)).y, -0.1F);
    hand.wall_lean = -0.4;
    EXPECT_GT(way_out_of(settled(hand).picture().tools.at(0)).y, 0.1F);
    hand.wall_lean = 1e9;
    EXPECT_GT(way_out_of(settled(hand).picture().tools.at(0)).y, -0.55F) << "no wrist bends further";
}

TEST(ToolPose, TiltsAsThePenThatGuidesIt) {
    const auto way = [](const dvec2& tilt_rad, double side) {
        DrawnHand hand = outside();
        hand.position_mm.x *= side;
        hand.tilt_rad = tilt_rad;
        return way_out_of(settled(hand).picture().tools.at(0));
    };
    for (const double side : {1.0, -1.0}) {
        EXPECT_LT(way({0.4 * side, 0.0}, side).y, way({0.0, 0.0}, side).y - 0.2F) << "outwards: lower";
        EXPECT_GT(way({-0.4 * side, 0.0}, side).y, way({0.0, 0.0}, side).y + 0.2F) << "over the pot: higher";
        EXPECT_GT(way({0.0, 0.3}, side).z, way({0.0, 0.0}, side).z + 0.2F) << "towards the visitor";
    }
}

TEST(ToolPose, KeepsATrimmerAboveTheWheel) {
    DrawnHand hand = outside();
    hand.tool = tool::Tool::kTrimmer;
    hand.wall_lean = 1.5;  // of a bowl, right above its foot
    for (const double y_mm : {8.0, 12.0, 20.0, 40.0}) {
        hand.position_mm.y = y_mm;
        const ShownTool tool = settled(hand).picture().tools.at(0);
        const vec4 end_of_handle(125.0F, -64.0F, 72.0F, 1.0F);  // assets/tools/maker/tools.py
        EXPECT_GT(vec3(tool.place * end_of_handle).y, 5.0F) << y_mm;
    }
}

TEST(ToolPose, HoldsItsTool) {
    DrawnHand hand = outside();
    hand.tool = tool::Tool::kRib;
    const ToolPicture rib = settled(hand).picture();
    ASSERT_EQ(rib.tools.size(), 2U);
    EXPECT_EQ(rib.tools[0].model, ToolModel::kRib);
    EXPECT_EQ(rib.tools[1].model, ToolModel::kHandOuter);
    EXPECT_GT(touch_of(rib.tools[1]).x, touch_of(rib.tools[0]).x + 10.0F);
    hand.tool = tool::Tool::kSponge;
    EXPECT_EQ(settled(hand).picture().tools.at(0).model, ToolModel::kSponge);
    hand.tool = tool::Tool::kTrimmer;
    EXPECT_EQ(settled(hand).picture().tools.at(0).model, ToolModel::kTrimmer);
}

// A stick that leaned as the belly of a vase does stood through its neck.
TEST(ToolPose, ReachesThroughTheMouthAndNotThroughTheWallBesideIt) {
    DrawnHand hand = inside(30.0);
    hand.guided = true;
    hand.radius_mm = 10.0;
    hand.position_mm = {26.0, 30.0, 0.0};
    hand.below_rim_mm = 100.0;
    for (const double touch_mm : {20.0, 36.0, 50.0}) {
        for (const double wall_lean : {-0.5, 0.0, 0.8}) {
            hand.position_mm.x = touch_mm - hand.radius_mm;
            hand.wall_lean = wall_lean;
            const ShownTool stick = settled(hand).picture().tools.at(0);
            ASSERT_EQ(stick.model, ToolModel::kStick);
            const vec3 up(stick.place[1]);
            ASSERT_GT(up.y, 0.5F);
            const vec3 at_rim = touch_of(stick) + up * (100.0F / up.y);
            EXPECT_LT(at_rim.x, 30.0F) << touch_mm << " mm, lean " << wall_lean;
        }
    }
}

TEST(ToolPose, ReachesIntoANarrowNeckWithAStick) {
    EXPECT_EQ(settled(inside(30.0)).picture().tools.at(0).model, ToolModel::kStick);
    // Between the two bounds it stays as it was.
    ToolPose pose = settled(inside(30.0));
    pose.follow(inside(49.0), 1.0);
    EXPECT_EQ(pose.picture().tools.at(0).model, ToolModel::kStick);
    pose.follow(inside(60.0), 1.0);
    EXPECT_EQ(pose.picture().tools.at(0).model, ToolModel::kHandInner);
}

TEST(ToolPose, ComesAndGoesInsteadOfAppearing) {
    ToolPose pose;
    pose.follow(outside(), kFrameS);
    double away = pose.away_mm();
    EXPECT_GT(away, 50.0);
    for (int frame = 0; frame < 60; ++frame) {
        pose.follow(outside(), kFrameS);
        EXPECT_LE(pose.away_mm(), away);
        away = pose.away_mm();
    }
    EXPECT_LT(away, 0.5);
    DrawnHand gone = outside();
    gone.shown = false;
    pose.follow(gone, kFrameS);
    EXPECT_FALSE(pose.picture().tools.empty());
    for (int frame = 0; frame < 60; ++frame)
        pose.follow(gone, kFrameS);
    EXPECT_TRUE(pose.picture().tools.empty());
    EXPECT_TRUE(pose.picture().shadows.empty());
}

TEST(ToolPose, KeepsItsHandNearTheAxis) {
    ToolPose pose = settled(outside());
    DrawnHand middle = outside();
    for (const double x : {10.0, 1.0, -1.0, -10.0, 0.0}) {
        middle.position_mm.x = x;
        pose.follow(middle, kFrameS);
        EXPECT_FALSE(pose.picture().tools.at(0).left) << x;
    }
}

// The guided hand of a finger that jumps to the other side of the pot.
TEST(ToolPose, GoesAndComesAgainWhereAFingerLeapsAcrossTheClay) {
    DrawnHand right = outside();
    right.guided = true;
    DrawnHand left = right;
    left.position_mm.x = -left.position_mm.x;
    ToolPose pose = settled(right);
    vec3 last = touch_of(pose.picture().tools.at(0));
    bool was_left = false;
    int frames = 0;
    for (; frames < 120 && !(was_left && pose.away_mm() == 0.0); ++frames) {
        pose.follow(left, kFrameS);
        const ToolPicture picture = pose.picture();
        if (picture.tools.empty()) continue;
        const vec3 now = touch_of(picture.tools.at(0));
        EXPECT_GT(std::abs(now.x), 69.0F) << "through the clay, in frame " << frames;
        const bool is_same_hand = picture.tools.at(0).left == was_left;
        EXPECT_LT(is_same_hand ? glm::distance(now, last) : 0.0F, 60.0F) << frames;
        was_left = picture.tools.at(0).left;
        last = now;
    }
    EXPECT_TRUE(was_left);
    EXPECT_LT(frames, 100);
    EXPECT_LT(glm::distance(last, vec3(-70.0F, 100.0F, 0.0F)), 0.1F);
}

TEST(ToolPose, TakesItsTimeWhereAFingerOnlyHovers) {
    DrawnHand works = outside();
    works.guided = true;
    DrawnHand hovers = works;
    hovers.touching = false;
    ToolPose working = settled(works);
    ToolPose hovering = settled(hovers);
    works.position_mm.y += 20.0;
    hovers.position_mm.y += 20.0;
    working.follow(works, kFrameS);
    hovering.follow(hovers, kFrameS);
    EXPECT_GT(touch_of(working.picture().tools.at(0)).y, touch_of(hovering.picture().tools.at(0)).y + 3.0F);
    EXPECT_GT(touch_of(hovering.picture().tools.at(0)).y, 100.0F);
}

TEST(ToolPose, DigsStraightDownAndLiesFlatOnARim) {
    DrawnHand hand = outside();
    hand.guided = true;
    hand.side = Side::kTop;
    EXPECT_LT(way_out_of(settled(hand).picture().tools.at(0)).y, 0.5F);
    hand.digs = true;
    EXPECT_GT(way_out_of(settled(hand).picture().tools.at(0)).y, 0.95F);
}

TEST(ToolPose, HoldsANarrowRimWithFingerTipsAndNoStick) {
    DrawnHand hand = inside(34.0);
    hand.guided = true;
    hand.below_rim_mm = 3.0;
    EXPECT_EQ(settled(hand).picture().tools.at(0).model, ToolModel::kHandInner);
    hand.below_rim_mm = 60.0;
    EXPECT_EQ(settled(hand).picture().tools.at(0).model, ToolModel::kStick);
}

TEST(ToolPose, CastsAShadowWithoutAModel) {
    for (const render::Sphere& ball : settled(outside()).picture().shadows) {
        EXPECT_GT(ball.centre_mm.x - ball.radius_mm, 69.0F) << "the stand-in reaches into the clay";
    }
}

}  // namespace
}  // namespace onggi::wheel

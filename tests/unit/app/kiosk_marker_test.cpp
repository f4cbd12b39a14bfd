// The marker that keys move along the clay, and the actions of keys there.
#include "game/app/kiosk/finger/kiosk_marker.h"
#include "tests/support/millimetre_pot.h"

#include <gtest/gtest.h>

namespace onggi::app {
namespace {

// A cone of millimetre rings that widens by `lean` a millimetre; hollow above floor_mm.
pot::Pot cone(double height_mm, double foot_mm, double lean, double floor_mm) {
    return test::millimetre_pot(height_mm, foot_mm, floor_mm, foot_mm - 8.0, lean);
}

class KioskMarkerTest : public ::testing::Test {
  protected:
    // Up until it is at the rim.
    void go_up(const pot::Pot& shape) {
        for (int step = 0; step < 100 && marker_.place_mm(shape).value_or(dvec2(0.0)).y < shape.height_mm;
             ++step)
            static_cast<void>(marker_.key(FingerKey::kUp, shape, 1.0));
    }

    const pot::Pot lump_ = cone(50, 62, 0.0, 50);
    const pot::Pot bowl_ = cone(100, 40, 0.75, 12);
    KioskMarker marker_;
};

TEST_F(KioskMarkerTest, ComesLowDownOnTheVisitorsSide) {
    EXPECT_FALSE(marker_.place_mm(lump_));
    static_cast<void>(marker_.key(FingerKey::kLeft, lump_, -1.0));
    EXPECT_EQ(*marker_.place_mm(lump_), dvec2(-62.0, 15.0));
    marker_.hide();
    EXPECT_FALSE(marker_.place_mm(lump_));
}

TEST_F(KioskMarkerTest, GoesFiveMillimetresAlongTheWall) {
    static_cast<void>(marker_.key(FingerKey::kLeft, bowl_, 1.0));
    const dvec2 before = *marker_.place_mm(bowl_);
    EXPECT_FALSE(marker_.key(FingerKey::kUp, bowl_, 1.0));
    const dvec2 after = *marker_.place_mm(bowl_);
    EXPECT_NEAR(glm::length(after - before), 5.0, 0.8);
    EXPECT_NEAR((after - before).x, 3.0, 0.8) << "along it, not straight up";
    EXPECT_FALSE(marker_.key(FingerKey::kDown, bowl_, 1.0));
    EXPECT_LT(glm::length(*marker_.place_mm(bowl_) - before), 1.0);
    for (int step = 0; step < 50; ++step)
        static_cast<void>(marker_.key(FingerKey::kDown, bowl_, 1.0));
    EXPECT_GE(marker_.place_mm(bowl_)->y, 4.5) << "not into the wheel";
}

TEST_F(KioskMarkerTest, MovesTheWallToTheSideThatIsSeen) {
    for (const double side : {1.0, -1.0}) {
        marker_.hide();
        const auto left = marker_.key(FingerKey::kLeft, bowl_, side);
        const auto right = marker_.key(FingerKey::kRight, bowl_, side);
        ASSERT_TRUE(left && right);
        EXPECT_LT(glm::length(left->points.front().place_mm - *marker_.place_mm(bowl_)), 5.0);
        EXPECT_EQ(left->points.front().place_mm.y, marker_.place_mm(bowl_)->y);
        EXPECT_LT(left->points.back().place_mm.x, left->points.front().place_mm.x);
        EXPECT_GT(right->points.back().place_mm.x, right->points.front().place_mm.x);
        EXPECT_NEAR(left->points.back().at_s, 0.4, 1e-9);
    }
}

TEST_F(KioskMarkerTest, PullsAtTheRimOfAnOpenedPot) {
    go_up(bowl_);
    const auto path = marker_.key(FingerKey::kUp, bowl_, 1.0);
    ASSERT_TRUE(path);
    EXPECT_LT(path->points.front().place_mm.y, 95.0) << "from the wall, not from the rim's edge";
    EXPECT_EQ(path->points.back().place_mm.y, 106.0);
}

TEST_F(KioskMarkerTest, OpensSolidClayFromOverItsMiddle) {
    go_up(lump_);
    EXPECT_FALSE(marker_.key(FingerKey::kUp, lump_, 1.0));
    EXPECT_EQ(*marker_.place_mm(lump_), dvec2(0.0, 50.0));
    EXPECT_FALSE(marker_.key(FingerKey::kUp, lump_, 1.0));
    const auto down = marker_.key(FingerKey::kDown, lump_, 1.0);
    ASSERT_TRUE(down);
    EXPECT_EQ(down->points.front().place_mm, dvec2(0.0, 50.0));
    EXPECT_LT(down->points.back().place_mm.y, 46.0);
    EXPECT_EQ(down->points.back().place_mm.x, 0.0);
    const pot::Pot opened = cone(55, 62, 0.0, 12);
    const auto wider = marker_.key(FingerKey::kDown, opened, 1.0);
    ASSERT_TRUE(wider);
    EXPECT_EQ(wider->points.back().place_mm.x, 8.0) << "there is nothing deeper";
    EXPECT_FALSE(marker_.key(FingerKey::kLeft, opened, 1.0)) << "back to the wall, on that side";
    EXPECT_EQ(*marker_.place_mm(opened), dvec2(-62.0, 55.0));
}

TEST_F(KioskMarkerTest, PullsFromOverTheMiddleOnceTheClayIsOpen) {
    go_up(lump_);
    static_cast<void>(marker_.key(FingerKey::kUp, lump_, 1.0));
    static_cast<void>(marker_.key(FingerKey::kDown, lump_, 1.0));
    const pot::Pot opened = cone(55, 62, 0.0, 12);
    const auto pull = marker_.key(FingerKey::kUp, opened, 1.0);
    ASSERT_TRUE(pull);
    EXPECT_EQ(pull->points.back().place_mm, dvec2(62.0, 61.0));
    EXPECT_EQ(*marker_.place_mm(opened), dvec2(62.0, 55.0)) << "at the rim that it draws up";
}

TEST_F(KioskMarkerTest, GoesUpWithAPotThatGrows) {
    static_cast<void>(marker_.key(FingerKey::kLeft, bowl_, 1.0));
    const pot::Pot taller = cone(150, 40, 0.5, 12);
    EXPECT_NEAR(marker_.place_mm(taller)->y, 45.0, 1e-9);
    go_up(bowl_);
    EXPECT_EQ(marker_.place_mm(taller)->y, 150.0);
}

TEST_F(KioskMarkerTest, GivesOneSwitchHigherLowerWiderAndNarrower) {
    const TouchPath higher = marker_.button(FingerKey::kUp, bowl_, 1.0);
    EXPECT_EQ(higher.points.back().place_mm.y, 112.0) << "wherever the marker is";
    const TouchPath lower = marker_.button(FingerKey::kDown, bowl_, 1.0);
    EXPECT_EQ(lower.points.front().place_mm.y, 100.0);
    EXPECT_EQ(lower.points.back().place_mm.y, 94.0);
    const TouchPath open = marker_.button(FingerKey::kDown, lump_, 1.0);
    EXPECT_EQ(open.points.front().place_mm.x, 0.0);
    EXPECT_GT(open.points.back().place_mm.x, 20.0) << "the whole way with one press";
    const TouchPath narrower = marker_.button(FingerKey::kLeft, bowl_, 1.0);
    EXPECT_LT(narrower.points.back().place_mm.x, narrower.points.front().place_mm.x);
    const TouchPath wider = marker_.button(FingerKey::kRight, bowl_, 1.0);
    EXPECT_GT(wider.points.back().place_mm.x, wider.points.front().place_mm.x);
}

TEST_F(KioskMarkerTest, BearsClayThatIsNotThere) {
    const pot::Pot nothing;
    for (const FingerKey key : {FingerKey::kUp, FingerKey::kDown, FingerKey::kLeft, FingerKey::kRight})
        static_cast<void>(marker_.key(key, nothing, 1.0));
    EXPECT_FALSE(marker_.place_mm(nothing));
}

}  // namespace
}  // namespace onggi::app

#include "game/decoration/picking.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/unit/decoration/sample_walls.h"

namespace onggi::decoration {
namespace {

TEST(Picking, FindsThePlaceUnderThePixel) {
    const Wall wall = sample_wall();
    const dvec3 eye(40.0, 260.0, 700.0);
    for (const double scale : {1.0, 0.93}) {
        for (int turn = 0; turn < 12; ++turn) {
            const double turned_rad = 0.7 * turn;
            const dvec2 turned(std::cos(turned_rad), std::sin(turned_rad));
            for (double height = 6.0; height < 154.0; height += 12.0) {
                // Places on the side of the eye: a quarter of a turn clockwise of +X is in front.
                for (double front = -0.15; front < 0.16; front += 0.05) {
                    const double turns = front + 0.75 - turned_rad / (2.0 * std::numbers::pi);
                    const dvec3 place = place_of(wall, scale, turned, turns, height);
                    const auto found = pick(wall, scale, turned, eye, glm::normalize(place - eye));
                    ASSERT_TRUE(found) << height;
                    double off = found->turns - turns;
                    off -= std::round(off);
                    EXPECT_LT(std::abs(off) * 377.0, 0.3) << height;
                    EXPECT_NEAR(found->height_mm, height, 0.3);
                    EXPECT_GT(found->facing, 0.0);
                }
            }
        }
    }
}

TEST(Picking, MissesBesideThePot) {
    const Wall wall = sample_wall();
    const dvec3 eye(0.0, 100.0, 700.0);
    EXPECT_FALSE(pick(wall, 1.0, {1.0, 0.0}, eye, glm::normalize(dvec3(75.0, 100.0, 0.0) - eye)));
    EXPECT_FALSE(pick(wall, 1.0, {1.0, 0.0}, eye, glm::normalize(dvec3(0.0, 400.0, 0.0) - eye)));
    EXPECT_FALSE(pick(wall, 1.0, {1.0, 0.0}, eye, dvec3(0.0, 0.0, 1.0)));  // behind
}

TEST(Picking, LooksOntoAShoulderLessSquarelyThanOntoABelly) {
    const Wall wall = sample_wall();
    const dvec3 eye(0.0, 100.0, 700.0);
    const auto belly = pick(wall, 1.0, {1.0, 0.0}, eye, glm::normalize(dvec3(0.0, 90.0, 60.0) - eye));
    const auto side = pick(wall, 1.0, {1.0, 0.0}, eye, glm::normalize(dvec3(58.0, 90.0, 5.0) - eye));
    ASSERT_TRUE(belly && side);
    EXPECT_GT(belly->facing, 0.95);
    EXPECT_LT(side->facing, 0.4);
}

}  // namespace
}  // namespace onggi::decoration

// Praise and advice for pots that differ from a museum's in one part only.
#include "game/heritage/advice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "tests/support/places.h"

namespace onggi::heritage {
namespace {

Target moon_jar() {
    const auto targets = load_targets(test::in_checkout("assets/heritage"));
    const auto jar = targets ? find_target(*targets, "moon-jar-nmk") : Result<Target>(targets.error());
    EXPECT_TRUE(jar);
    return jar ? *jar : Target{};
}

PotForm like(const Target& target, double scale) {
    PotForm form = form_of(target);
    form.height_mm *= scale;
    for (double& radius : form.radii_mm)
        radius *= scale;
    form.wall_mm = 5.0;
    return form;
}

TEST(Advice, SuggestsAnotherPotIfThisOneIsCloseEnough) {
    const Target jar = moon_jar();
    const Advice advice = advise(like(jar, 0.5), jar, 0.5);
    EXPECT_FALSE(advice.next);
    EXPECT_EQ(next_key(advice), "tip.next.other");
}

TEST(Advice, NamesThePartThatIsFarthestOffAndWhichWay) {
    const Target jar = moon_jar();
    PotForm narrow = like(jar, 0.5);
    narrow.radii_mm.back() *= 0.8;
    EXPECT_EQ(next_key(advise(narrow, jar, 0.5)), "tip.next.mouth.more");
    EXPECT_NE(good_key(advise(narrow, jar, 0.5)), "tip.good.mouth");
    PotForm broad = like(jar, 0.5);
    broad.radii_mm.front() *= 1.3;
    EXPECT_EQ(next_key(advise(broad, jar, 0.5)), "tip.next.foot.less");
    PotForm thick = like(jar, 0.5);
    thick.wall_mm = 13.0;  // in a level cut
    EXPECT_EQ(next_key(advise(thick, jar, 0.5)), "tip.next.wall.less");
    PotForm thin = like(jar, 0.5);
    thin.wall_mm = 1.0;
    EXPECT_FALSE(advise(thin, jar, 0.5).next) << "no advice to leave more clay in a wall";
}

TEST(Advice, NamesAThickWallBeforeTheOutline) {
    const Target jar = moon_jar();
    PotForm pot = like(jar, 0.5);
    pot.radii_mm.front() *= 1.8;
    EXPECT_EQ(next_key(advise(pot, jar, std::nullopt)), "tip.next.foot.less");
    pot.wall_mm = 19.0;
    EXPECT_EQ(next_key(advise(pot, jar, std::nullopt)), "tip.next.wall.less");
    pot.wall_mm.reset();
    EXPECT_EQ(next_key(advise(pot, jar, std::nullopt)), "tip.next.hollow") << "a solid lump";
}

// A dish's wall is wide in a level cut, however thin it is.
TEST(Advice, MeasuresAWallAcrossItsLean) {
    const Target jar = moon_jar();
    PotForm dish = like(jar, 0.5);
    dish.height_mm = 40.0;
    for (std::size_t i = 0; i < dish.radii_mm.size(); ++i)
        dish.radii_mm[i] = 30.0 + 0.6 * static_cast<double>(i);
    dish.wall_mm = 12.0;
    EXPECT_NE(next_key(advise(dish, jar, std::nullopt)), "tip.next.wall.less");
    dish.wall_mm = 25.0;
    EXPECT_EQ(next_key(advise(dish, jar, std::nullopt)), "tip.next.wall.less");
}

TEST(Advice, ComparesAFootAndAMouthByTheWidthOfTheWholePot) {
    const Target jar = moon_jar();
    PotForm pot = like(jar, 0.5);
    pot.radii_mm.front() += 6.0;
    pot.radii_mm.back() -= 8.0;
    EXPECT_EQ(next_key(advise(pot, jar, 0.5)), "tip.next.mouth.more") << "the foot is less far off";
}

TEST(Advice, PraisesNoBellyOfAStraightWall) {
    const Target jar = moon_jar();
    PotForm cylinder = like(jar, 0.5);
    for (double& radius : cylinder.radii_mm)
        radius = 0.5 * cylinder.widest_mm();
    EXPECT_NE(good_key(advise(cylinder, jar, 0.5)), "tip.good.belly");
    PotForm slim = like(jar, 0.5);
    for (double& radius : slim.radii_mm)
        radius = std::min(radius, 1.1 * std::max(slim.radii_mm.front(), slim.radii_mm.back()));
    EXPECT_EQ(next_key(advise(slim, jar, 0.5)), "tip.next.belly.more");
}

TEST(Advice, PraisesNoMouthOfALumpThatWasNeverOpened) {
    const Target jar = moon_jar();
    PotForm lump = like(jar, 0.5);
    lump.wall_mm.reset();
    lump.height_mm *= 0.7;
    lump.radii_mm.front() *= 1.5;
    const Advice advice = advise(lump, jar, std::nullopt);
    EXPECT_NE(advice.good, PotPart::kMouth);
    EXPECT_NE(advice.good, PotPart::kWall);
    lump.radii_mm.back() *= 3.0;
    EXPECT_NE(advise(lump, jar, 0.5).next, PotPart::kMouth);
}

TEST(Advice, AsksForTheSizeOnlyWhereItWasMeant) {
    const Target jar = moon_jar();
    EXPECT_EQ(next_key(advise(like(jar, 0.4), jar, 0.5)), "tip.next.height.more");
    EXPECT_FALSE(advise(like(jar, 0.4), jar, std::nullopt).next);
    EXPECT_NE(advise(like(jar, 0.4), jar, std::nullopt).good, PotPart::kHeight);
}

TEST(Advice, IsSaidInTwoLines) {
    const Target jar = moon_jar();
    PotForm wide = like(jar, 0.5);
    wide.radii_mm.back() *= 1.4;
    EXPECT_EQ(report(advise(wide, jar, 0.5)),
              "  good         the right height\n  try next     a closer mouth\n");
}

}  // namespace
}  // namespace onggi::heritage

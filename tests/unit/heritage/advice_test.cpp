// Praise and advice for pots that differ from a museum's in one part only.
#include "game/heritage/advice.h"

#include <gtest/gtest.h>

#include <algorithm>

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
    thick.wall_mm = 11.0;
    EXPECT_EQ(next_key(advise(thick, jar, 0.5)), "tip.next.wall.less");
    PotForm thin = like(jar, 0.5);
    thin.wall_mm = 1.0;
    EXPECT_FALSE(advise(thin, jar, 0.5).next) << "no advice to leave more clay in a wall";
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

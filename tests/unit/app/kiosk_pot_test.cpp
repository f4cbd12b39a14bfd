// The pot as it comes out of the kiln, beside the museum's pot that it resembles.
#include "game/app/kiosk/presentation/kiosk_pot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "game/app/kiosk/kiosk_settings.h"
#include "game/app/kiosk/presentation/exhibits.h"
#include "game/heritage/jar.h"
#include "game/heritage/score.h"

namespace onggi::app {
namespace {

KioskSettings settings() {
    auto loaded = load_settings("");
    EXPECT_TRUE(loaded);
    EXPECT_TRUE(loaded->remarks.empty());
    return std::move(*loaded);
}

// Clay thrown after that pot's outline, 120 mm high or 130 mm across.
clay::StudioClay thrown_after(const heritage::Target& target) {
    clay::StudioClay clay;
    const double scale = std::min(120.0 / target.height_mm, 130.0 / target.drawn_diameter_mm());
    constexpr int kRings = 600;
    clay.set_wall(50.0, 4.0, 6.0, scale * target.height_mm, kRings);
    std::vector<double> outer(kRings);
    std::vector<double> inner(kRings);
    for (std::size_t i = 0; i < outer.size(); ++i) {
        outer[i] = scale * target.radius_at(target.height_mm * (static_cast<double>(i) + 0.5) / kRings);
        inner[i] = i < 30 ? 0.0 : std::max(1.0, outer[i] - 4.0);
    }
    clay.set_profile(outer, inner);
    return clay;
}

TEST(FiredPot, StandsBesideTheMostSimilarPotOfTheTables) {
    const KioskSettings kiosk = settings();
    ASSERT_GT(kiosk.targets.size(), kiosk.exhibits->size());
    ASSERT_EQ(kiosk.relatives->size(), kiosk.targets.size());
    std::set<std::string> found;
    for (std::size_t place = 0; place < kiosk.targets.size(); ++place) {
        const screens::FiredPot pot =
            fired_pot(thrown_after(kiosk.targets[place]), kiosk.targets, kiosk.relatives);
        ASSERT_TRUE(pot.relative);
        EXPECT_EQ(pot.relative.get(), &(*kiosk.relatives)[place]) << kiosk.targets[place].id;
        found.insert(pot.relative->name_key);
    }
    EXPECT_TRUE(found.contains("pot.kylix")) << "which the choose screen does not show";
}

TEST(FiredPot, HasNoRelativeWithoutMuseumPots) {
    const clay::StudioClay clay;
    EXPECT_FALSE(fired_pot(clay, {}, nullptr).relative);
    EXPECT_FALSE(fired_pot(clay, settings().targets, nullptr).relative);
}

// The score that the screen shows is against the pot that the visitor chose, at the size it was thrown.
TEST(FiredPot, IsScoredAgainstThePotThatWasChosen) {
    const KioskSettings kiosk = settings();
    const std::size_t chosen = 1;
    const clay::StudioClay like_another = thrown_after(kiosk.targets[0]);
    const screens::FiredPot pot = fired_pot(like_another, kiosk.targets, kiosk.relatives, chosen);
    EXPECT_EQ(pot.relative.get(), &(*kiosk.relatives)[chosen]);
    ASSERT_TRUE(pot.off_outline_mm);
    const heritage::Target& target = kiosk.targets[chosen];
    EXPECT_EQ(*pot.off_outline_mm, heritage::profile_rms_mm(heritage::form_of(like_another), target,
                                                            heritage::size_on_this_wheel(target).fraction));
    EXPECT_FALSE(fired_pot(like_another, kiosk.targets, kiosk.relatives).off_outline_mm)
        << "nobody chose the pot that it resembles";
}

// An open pot of a kilogram with that wall, upright or leaning outwards.
pot::Pot walled(double wall_mm, double lean) {
    constexpr int kRings = 100;
    pot::Pot pot;
    pot.height_mm = 100.0;
    pot.floor_mm = 10.0;
    for (int ring = 0; ring < kRings; ++ring) {
        const double outer_mm = 45.0 + lean * ring;
        const double level_mm = wall_mm * std::hypot(1.0, lean);
        pot.outer_mm.push_back(static_cast<float>(outer_mm));
        pot.inner_mm.push_back(ring < 10 ? 0.0F : static_cast<float>(outer_mm - level_mm));
    }
    return pot;
}

TEST(ThickWall, IsNamedByItsThickestPlaceAndNotWhereItIsThinEnough) {
    EXPECT_EQ(thick_wall_mm(walled(22.0, 0.0)), 22);
    EXPECT_EQ(thick_wall_mm(walled(11.5, 0.0)), 12) << "in the mean, too thick";
    EXPECT_EQ(thick_wall_mm(walled(6.0, 0.0)), 0);
    pot::Pot base = walled(6.0, 0.0);
    for (std::size_t ring = 10; ring < 30; ++ring)
        base.inner_mm[ring] = base.outer_mm[ring] - 18.0F;
    EXPECT_EQ(thick_wall_mm(base), 18) << "low down, where clay is left";
    for (std::size_t ring = 15; ring < 30; ++ring)
        base.inner_mm[ring] = base.outer_mm[ring] - 6.0F;
    EXPECT_EQ(thick_wall_mm(base), 0) << "the round between floor and wall";
    pot::Pot solid = walled(22.0, 0.0);
    solid.floor_mm = solid.height_mm;
    EXPECT_EQ(thick_wall_mm(solid), 0) << "there is another question about solid clay";
}

TEST(ThickWall, IsMeasuredAcrossItsLean) {
    EXPECT_EQ(thick_wall_mm(walled(7.0, 1.7)), 0) << "a dish, 14 mm wide in a level cut";
    EXPECT_NEAR(thick_wall_mm(walled(17.0, 1.0)), 17, 1);
}

TEST(Relatives, HaveTextsInEveryLanguageOrShowTheTablesName) {
    const KioskSettings kiosk = settings();
    for (const screens::Exhibit& relative : *kiosk.relatives)
        for (const kiosk::Language& language : *kiosk.languages)
            for (const std::string& key : {relative.name_key, relative.museum_key, relative.date_key})
                EXPECT_TRUE(key.empty() || language.has(key)) << language.code() << ' ' << key;
    heritage::Target own = kiosk.targets.front();
    own.id = "own-pot";
    own.name = "A jar of this museum's";
    const auto relatives = relatives_of({own}, {});
    EXPECT_EQ(kiosk.languages->front().shown(relatives.front().name_key), own.name);
}

}  // namespace
}  // namespace onggi::app

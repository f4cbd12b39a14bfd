// The pot as it comes out of the kiln, beside the museum's pot that it resembles.
#include "game/app/kiosk/presentation/kiosk_pot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "game/app/kiosk/kiosk_settings.h"
#include "game/app/kiosk/presentation/exhibits.h"

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

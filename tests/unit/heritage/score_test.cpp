// A score in a museum's units, and the nearest pot whatever its size.
#include "game/heritage/score.h"
#include "tests/unit/heritage/bundled.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace onggi::heritage {
namespace {

Target target_of(std::string_view id) {
    const auto targets = bundled();
    auto target = find_target(targets, id);
    EXPECT_TRUE(target);
    return target ? *target : Target{};
}

const Measure& measure(const Score& score, std::string_view name) {
    return *std::find_if(score.measures.begin(), score.measures.end(),
                         [&](const Measure& one) { return one.name == name; });
}

// A straight-walled pot of stoneware, wet lengths.
clay::StudioClay cylinder(double outer_mm, double wall_mm, double floor_mm, double height_mm) {
    clay::StudioClay pot({.mass_g = 500.0});
    pot.set_wall(outer_mm, wall_mm, floor_mm, height_mm, 1000);
    return pot;
}

TEST(HeritageScore, MeasuresAFiredPotAsAMuseumDoes) {
    const PotForm form = form_of(cylinder(50.0, 5.0, 10.0, 100.0));
    // Stoneware shrinks by 12 %.
    EXPECT_NEAR(form.height_mm, 88.0, 1e-6);
    EXPECT_NEAR(form.widest_mm(), 88.0, 1e-6);
    EXPECT_NEAR(form.mouth_mm(), 88.0, 1e-6);
    EXPECT_NEAR(form.foot_mm(), 88.0, 1e-6);
    EXPECT_NEAR(form.wall_mm.value(), 4.4, 1e-6);
    // pi 45^2 x 90 mm, fired.
    EXPECT_NEAR(form.capacity_ml.value(), M_PI * 45.0 * 45.0 * 90.0 * 1e-3 * std::pow(0.88, 3), 0.5);
}

TEST(HeritageScore, IsTheDifferenceOfThePublishedMeasuresInMillimetres) {
    const Target kylix = target_of("kylix-ringling");  // 82.5 high, 205, mouth 201, foot 79.7, wall 4
    const Score score =
        heritage::score(form_of(cylinder(100.0, 5.0, 10.0, 90.0)), kylix, clay::ClayBody::kStoneware);
    EXPECT_EQ(score.size.fraction, 1.0);
    EXPECT_NEAR(score.size.wet_scale, 1.0 / 0.88, 1e-12);
    EXPECT_NEAR(measure(score, "height_mm").pot, 79.2, 1e-4);
    EXPECT_EQ(measure(score, "height_mm").target, 82.5);
    EXPECT_EQ(measure(score, "widest_mm").target, 205.0);
    EXPECT_EQ(measure(score, "wall_mm").target, 4.0);
    EXPECT_FALSE(measure(score, "mass_g").target) << "its mass is not published";
    EXPECT_FALSE(measure(score, "capacity_ml").target);
    // 3.3, 29, 25, 96.3 and 0.4 mm.
    EXPECT_NEAR(score.mean_off_mm, (3.3 + 29.0 + 25.0 + 96.3 + 0.4) / 5.0, 1e-3);
}

TEST(HeritageScore, IgnoresUnpublishedMeasures) {
    const Target maebyeong = target_of("maebyeong-1869");
    const Score score =
        heritage::score(form_of(cylinder(50.0, 5.0, 10.0, 300.0)), maebyeong, clay::ClayBody::kStoneware);
    EXPECT_FALSE(measure(score, "widest_mm").target);
    const double fraction = score.size.fraction;
    EXPECT_NEAR(score.mean_off_mm,
                (std::fabs(264.0 - 303.0 * fraction) + std::fabs(88.0 - 50.0 * fraction) +
                 std::fabs(88.0 - 105.0 * fraction)) /
                    3.0,
                1e-3);
    EXPECT_EQ(score.published_points, 2U);  // mouth and foot
    EXPECT_NE(report(score, maebyeong).find("not published"), std::string::npos);
}

TEST(HeritageScore, OfATargetsOwnOutlineIsNoughtInProfile) {
    for (const Target& target : bundled()) {
        PotForm own = form_of(target);
        const double fraction = thrown_size(target, clay::ClayBody::kPorcelain).fraction;
        own.height_mm *= fraction;
        for (double& radius : own.radii_mm)
            radius *= fraction;
        if (own.wall_mm) *own.wall_mm *= fraction;
        if (own.mass_g) *own.mass_g *= fraction * fraction * fraction;
        const Score score = heritage::score(own, target, clay::ClayBody::kPorcelain);
        EXPECT_NEAR(score.profile_rms_mm, 0.0, 1e-9) << target.id;
        EXPECT_NEAR(score.mean_off_mm, 0.0, 0.35) << target.id;  // the widest point may lie between samples
    }
}

TEST(HeritageScore, GivesTheProfilesRootMeanSquare) {
    const Target bowl = target_of("buncheong-bowl");
    PotForm wider = form_of(bowl);
    for (double& radius : wider.radii_mm)
        radius += 3.0;
    EXPECT_NEAR(heritage::score(wider, bowl, clay::ClayBody::kStoneware).profile_rms_mm, 3.0, 1e-9);
}

TEST(HeritageSize, FitsTheWheelAndTheClay) {
    const auto fraction = [](std::string_view id) {
        return thrown_size(target_of(id), clay::ClayBody::kStoneware).fraction;
    };
    EXPECT_EQ(fraction("buncheong-small-bowl"), 1.0);
    EXPECT_LE(fraction("moon-jar-nmk"), 0.75);
    EXPECT_LE(fraction("amphora-met"), 0.5);
    for (const Target& target : bundled()) {
        for (const auto body :
             {clay::ClayBody::kStoneware, clay::ClayBody::kPorcelain, clay::ClayBody::kEarthenware}) {
            const ThrownSize size = thrown_size(target, body);
            EXPECT_LE(size.wet_scale * target.height_mm, 350.0) << target.id;
            EXPECT_LE(size.wet_scale * target.drawn_diameter_mm(), 300.0) << target.id;
            EXPECT_NEAR(size.wet_scale, size.fraction * clay::wet_scale_of_fired(body), 1e-12);
            EXPECT_FALSE(size.text.empty());
        }
    }
}

TEST(HeritageNearest, FindsATargetByItsOwnShapeAtAnySize) {
    const auto targets = bundled();
    for (std::size_t i = 0; i < targets.size(); ++i) {
        PotForm form = form_of(targets[i]);
        form.height_mm *= 0.37;
        for (double& radius : form.radii_mm)
            radius *= 0.37;
        const Nearest found = nearest(form, targets);
        EXPECT_EQ(found.target, i) << targets[i].id << " taken for " << targets[found.target].id;
        EXPECT_LT(found.unlikeness, 1e-7);
    }
}

TEST(HeritageNearest, MatchesALowWideDishWithABowlAndATallPotWithNoBowl) {
    const auto targets = bundled();
    const PotForm dish = form_of(cylinder(90.0, 5.0, 10.0, 60.0));
    const std::string low = targets[nearest(dish, targets).target].id;
    EXPECT_NE(low.find("bowl"), std::string::npos) << low;
    const PotForm tall = form_of(cylinder(40.0, 5.0, 10.0, 300.0));
    const std::string high = targets[nearest(tall, targets).target].id;
    EXPECT_EQ(high.find("bowl"), std::string::npos) << high;
    EXPECT_GT(unlikeness(dish, tall), 0.5);
    EXPECT_NEAR(unlikeness(dish, tall), unlikeness(tall, dish), 1e-12);
}

}  // namespace
}  // namespace onggi::heritage

// The museum's pots: the bundled ones are sound, and a table that is not is refused with its line.
#include "game/heritage/target.h"
#include "tests/support/refusal.h"
#include "tests/unit/heritage/bundled.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace onggi::heritage {
namespace {

TEST(HeritageTargets, AreTwentyThreeWithTheirPublishedMeasures) {
    const auto targets = bundled();
    ASSERT_EQ(targets.size(), 23U);
    const auto jar = find_target(targets, "moon-jar-nmk");
    ASSERT_TRUE(jar);
    EXPECT_EQ(jar->height_mm, 305.0);
    EXPECT_EQ(jar->max_diameter_mm, 302.0);
    EXPECT_EQ(jar->mouth_mm, 142.0);
    EXPECT_EQ(jar->foot_mm, 120.0);
    EXPECT_FALSE(jar->wall_mm);
    EXPECT_FALSE(jar->mass_g);
    EXPECT_EQ(jar->culture_date, "Joseon, 18th c.");
    const auto maebyeong = find_target(targets, "maebyeong-1869");
    ASSERT_TRUE(maebyeong);
    EXPECT_FALSE(maebyeong->max_diameter_mm);
}

TEST(HeritageTargets, HaveOutlinesThroughTheirPublishedMeasures) {
    for (const Target& target : bundled()) {
        SCOPED_TRACE(target.id);
        if (target.foot_mm) {
            EXPECT_NEAR(2.0 * target.radius_at(0.0), *target.foot_mm, 0.05);
        }
        if (target.mouth_mm) {
            EXPECT_NEAR(2.0 * target.radius_at(target.height_mm), *target.mouth_mm, 0.05);
        }
        double widest = 0.0;
        for (double y = 0.0; y <= target.height_mm; y += 0.1)
            widest = std::max(widest, 2.0 * target.radius_at(y));
        EXPECT_LE(widest, target.drawn_diameter_mm() * (1.0 + 1e-12));
        EXPECT_NEAR(widest, target.drawn_diameter_mm(), 0.1);
        if (target.max_diameter_mm) {
            EXPECT_NEAR(widest, *target.max_diameter_mm, 0.1);
        }
        for (const OutlinePoint& point : target.outline)
            EXPECT_NEAR(target.radius_at(point.y_mm), point.radius_mm, 1e-9);
    }
}

TEST(HeritageTargets, HaveADescriptionInOneLine) {
    const auto targets = bundled();
    for (const Target& target : targets) {
        const std::string line = sentence(target);
        EXPECT_EQ(line.find('\n'), std::string::npos);
        EXPECT_LT(line.size(), 200U) << line;
        EXPECT_NE(line.find(target.name), std::string::npos);
        EXPECT_NE(line.find(target.place), std::string::npos);
    }
    EXPECT_EQ(sentence(*find_target(targets, "moon-jar-nmk")),
              "Moon jar (small), Joseon, 18th c., National Museum of Korea: 305 mm high, 302 mm across; two "
              "joined bowls.");
}

TEST(HeritageTargets, RejectAnUnknownIdListingThoseKnown) {
    const auto unknown = find_target(bundled(), "moon");
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().kind, ErrorKind::kBadInput);
    EXPECT_NE(unknown.error().message.find("expected one of moon-jar-nmk, moon-jar-bm"), std::string::npos);
    EXPECT_NE(unknown.error().message.find("found 'moon'"), std::string::npos);
}

constexpr std::string_view kGoodOutline =
    "cup,0,20,published\ncup,10,30,drawn\ncup,50,40,published\ncup,80,35,drawn\n";

std::string refusal_of_rows(std::string_view rows, std::string_view outline = kGoodOutline) {
    return test::refusal(parse_targets(fmt::format("{}\n{}", kTargetsHeader, rows),
                                       fmt::format("{}\n{}", kOutlinesHeader, outline), "t.csv", "o.csv"));
}

constexpr std::string_view kGood = "cup,Cup,Museum 1,then,80,80,,40,,,record 1,\n";

TEST(HeritageTargets, AreReadFromTables) {
    const auto targets = parse_targets(fmt::format("{}\n{}", kTargetsHeader, kGood),
                                       fmt::format("{}\n{}", kOutlinesHeader, kGoodOutline), "t", "o");
    ASSERT_TRUE(targets) << targets.error().message;
    ASSERT_EQ(targets->size(), 1U);
    EXPECT_EQ((*targets)[0].outline.size(), 4U);
    EXPECT_EQ((*targets)[0].drawn_diameter_mm(), 80.0);
}

TEST(HeritageTargets, RejectRowsOutOfBounds) {
    EXPECT_EQ(refusal_of_rows("Cup,Cup,M,then,80,80,,40,,,r,\n"),
              "t.csv:2: id: expected letters a to z, digits and -, found 'Cup'");
    EXPECT_EQ(refusal_of_rows(fmt::format("{}{}", kGood, kGood)),
              "t.csv:3: id: expected each target once, found cup again");
    EXPECT_EQ(refusal_of_rows("cup,,M,then,80,80,,40,,,r,\n"),
              "t.csv:2: name, object and source: expected all three");
    EXPECT_EQ(refusal_of_rows("cup,Cup,M,then,,80,,40,,,r,\n"),
              "t.csv:2: height_mm: expected 1 to 2000, found nothing");
    EXPECT_EQ(refusal_of_rows("cup,Cup,M,then,80mm,80,,40,,,r,\n"),
              "t.csv:2: height_mm: expected nothing or 1 to 2000, found '80mm'");
    // Other readers of tables drop the comma (findings/csvkit-reads-a-height-of-6-comma-8-as-68.sh).
    EXPECT_EQ(refusal_of_rows("cup,Cup,M,then,\"80,5\",80,,40,,,r,\n"),
              "t.csv:2: height_mm: expected nothing or 1 to 2000, found '80,5'");
    EXPECT_EQ(refusal_of_rows("cup,Cup,M,then,80 3/8,80,,40,,,r,\n"),
              "t.csv:2: height_mm: expected nothing or 1 to 2000, found '80 3/8'");
    EXPECT_EQ(refusal_of_rows("cup,Cup,M,then,80,nan,,40,,,r,\n"),
              "t.csv:2: max_diameter_mm: expected nothing or 1 to 2000, found 'nan'");
    EXPECT_EQ(refusal_of_rows("cup,Cup,M,then,80,80,,0,,,r,\n"),
              "t.csv:2: foot_mm: expected nothing or 1 to 2000, found '0'");
    EXPECT_EQ(refusal_of_rows("cup,Cup,M,then,80,80,90,40,,,r,\n"),
              "t.csv:2: mouth_mm and foot_mm: expected at most the largest diameter of 80, found 90");
}

TEST(HeritageTargets, RejectOutlinesThatContradictPublishedMeasures) {
    const auto of = [](std::string_view outline) { return refusal_of_rows(kGood, outline); };
    EXPECT_EQ(of("jug,0,20,drawn\n"), "o.csv:2: id: expected a target's, found 'jug'");
    EXPECT_EQ(of("cup,0,20,ours\n"), "o.csv:2: basis: expected published or drawn, found 'ours'");
    EXPECT_EQ(of("cup,0,20,published\n"), "o.csv:2: outline of cup: expected at least 4 points, found 1");
    EXPECT_EQ(of("cup,1,20,published\ncup,10,30,drawn\ncup,50,40,published\ncup,80,35,drawn\n"),
              "o.csv:5: outline of cup: expected y = 0 first, found 1");
    EXPECT_EQ(of("cup,0,20,published\ncup,10,30,drawn\ncup,50,40,published\ncup,70,35,drawn\n"),
              "o.csv:5: outline of cup: expected to end at 80 mm, found 70");
    EXPECT_EQ(of("cup,0,20,published\ncup,50,40,published\ncup,50,30,drawn\ncup,80,35,drawn\n"),
              "o.csv:5: outline of cup: expected heights that rise, found 50 after 50");
    EXPECT_EQ(of("cup,0,22,published\ncup,10,30,drawn\ncup,50,40,published\ncup,80,35,drawn\n"),
              "o.csv:5: outline of cup: expected the published foot of 40 mm");
    EXPECT_EQ(of("cup,0,20,published\ncup,10,30,drawn\ncup,50,41,published\ncup,80,35,drawn\n"),
              "o.csv:5: outline of cup: expected the published largest diameter of 80 mm, found 82");
    EXPECT_EQ(of("cup,0,20,published\ncup,10,30,published\ncup,50,40,published\ncup,80,35,drawn\n"),
              "o.csv:5: outline of cup: expected the basis drawn at 10 mm");
    EXPECT_EQ(of("cup,0,20,drawn\ncup,10,30,drawn\ncup,50,40,published\ncup,80,35,drawn\n"),
              "o.csv:5: outline of cup: expected the basis published at 0 mm");
    EXPECT_EQ(refusal_of_rows("cup,Cup,M,then,80,80,60,40,,,r,\n"),
              "o.csv:5: outline of cup: expected the published mouth of 60 mm");
}

}  // namespace
}  // namespace onggi::heritage

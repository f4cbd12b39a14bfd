#include "game/finish/drawn_with.h"

#include <gtest/gtest.h>

#include "game/decoration/canvas.h"

namespace onggi::finish {
namespace {

using decoration::Motif;
using decoration::Slip;
using decoration::Stroke;
using decoration::Strokes;
using decoration::Technique;

decoration::Wall cylinder() {
    std::vector<vec2> outline;
    for (int i = 0; i <= 30; ++i)
        outline.push_back({40.0F, 4.0F * static_cast<float>(i)});
    return decoration::wall_of(outline);
}

Stroke band(Technique technique, double height_mm, Slip slip = Slip::kWhite) {
    constexpr int kPoints = 64;
    Stroke stroke{.technique = technique, .slip = slip, .width = 600};
    for (int i = 0; i <= kPoints; ++i)
        stroke.points.push_back(
            decoration::stroke_point(static_cast<double>(i) / kPoints, height_mm).value());
    return stroke;
}

DrawnWith drawn(const Strokes& strokes) {
    auto canvas = decoration::Canvas::of(cylinder(), strokes);
    if (!canvas) return {};
    return drawn_with(canvas->texture(), strokes);
}

std::vector<Glaze> hiding(const Strokes& strokes) {
    const DrawnWith with = drawn(strokes);
    std::vector<Glaze> all;
    for (const GlazeMaterial& glaze : glazes()) {
        if (hides(glaze, with)) all.push_back(glaze.glaze);
    }
    return all;
}

using Glazes = std::vector<Glaze>;

TEST(DrawnWith, NoGlazeHidesAPlainPot) {
    EXPECT_TRUE(drawn({}).nothing());
    EXPECT_EQ(hiding({}), Glazes{});
    EXPECT_EQ(hiding({band(Technique::kIron, 60.0), {.technique = Technique::kClear}}), Glazes{});
}

TEST(DrawnWith, WhiteVanishesOnWhiteAndEverythingUnderIron) {
    EXPECT_EQ(hiding({band(Technique::kInlay, 60.0)}), (Glazes{Glaze::kPorcelain, Glaze::kIron}));
    EXPECT_EQ(hiding({band(Technique::kBrushedSlip, 60.0)}), (Glazes{Glaze::kPorcelain, Glaze::kIron}));
    EXPECT_EQ(hiding({band(Technique::kIron, 60.0)}), Glazes{Glaze::kIron});
    EXPECT_EQ(hiding({band(Technique::kCobalt, 60.0)}), Glazes{Glaze::kIron});
    EXPECT_EQ(hiding({band(Technique::kInlay, 60.0, Slip::kBlack)}), Glazes{Glaze::kIron});
}

TEST(DrawnWith, FingerWipesAreAlwaysVisible) {
    EXPECT_GT(drawn({band(Technique::kFinger, 60.0)}).wiped, 0U);
    EXPECT_EQ(hiding({band(Technique::kFinger, 60.0)}), Glazes{});
}

TEST(DrawnWith, VisiblePartsCountBesideHiddenOnes) {
    EXPECT_EQ(hiding({band(Technique::kInlay, 40.0), band(Technique::kIron, 80.0)}), Glazes{Glaze::kIron});
}

TEST(DrawnWith, KnowsInlayUntilItIsWipedOff) {
    EXPECT_TRUE(drawn({band(Technique::kInlay, 60.0)}).inlaid);
    const Stroke crane{.technique = Technique::kMotif,
                       .motif = Motif::kCrane,
                       .width = 4000,
                       .points = {decoration::stroke_point(0.0, 60.0).value()}};
    EXPECT_TRUE(drawn({crane}).inlaid);
    EXPECT_FALSE(drawn({band(Technique::kBrushedSlip, 60.0)}).inlaid);
    const Strokes wiped{crane, {.technique = Technique::kClear}, band(Technique::kIron, 60.0)};
    EXPECT_FALSE(drawn(wiped).inlaid);
}

}  // namespace
}  // namespace onggi::finish

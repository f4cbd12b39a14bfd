#include "game/screens/page/design.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/ui/path.h"
#include "game/screens/page/icons.h"
#include "game/screens/page/legibility.h"

namespace onggi::screens::design {
namespace {

struct Pair {
    const char* name;
    Colour words;
    Colour ground;
    float least;  // 4.5 for words, 3 for signs
};

TEST(Design, KeepsEveryPairOfColoursApart) {
    const Colour window = ui::hex(0xf5f9fd);
    const Colour chip = ui::over(kNight.with_alpha(0.86F), window);
    const Pair kPairs[] = {
        {"ink on hanji", kInk, kHanji, 4.5F},
        {"ink on porcelain", kInk, kPorcelain, 4.5F},
        {"ink on a token", kInk, kTokenLo, 4.5F},
        {"ink on celadon", kInk, kCeladonLo, 4.5F},
        {"second ink on hanji", kInk2, kHanji, 4.5F},
        {"second ink on porcelain", kInk2, kPorcelain, 4.5F},
        {"rust on hanji", kRust, kHanji, 4.5F},
        {"dots on a token", kDot, kTokenLo, 4.5F},
        {"slip on night", kSlip, kNight, 4.5F},
        {"slip on the ledge's top", kSlip, kNightTop, 4.5F},
        {"slip on the wall", kSlip, kWall, 4.5F},
        {"slip on a niche", kSlip, kNiche, 4.5F},
        {"second slip on night", kSlip2, kNight, 4.5F},
        {"second slip on the wall", kSlip2, kWall, 4.5F},
        {"third slip on night", kSlip3, kNight, 4.5F},
        {"slip on an outline token before the window", kSlip, ui::over(kNight.with_alpha(0.82F), window),
         4.5F},
        {"slip on the least scrim before the window", kSlip, ui::over(kNight.with_alpha(0.66F), window),
         4.5F},
        {"stiffness by name on its chip before the window", kStiffness, chip, 4.5F},
        {"viscosity by name on its chip before the window", kViscosity, chip, 4.5F},
        {"friction by name on its chip before the window", kFriction, chip, 4.5F},
        {"the sum by name on its chip before the window", kWhiteSlip, chip, 4.5F},
        {"amber on night", kAmber, kNight, 3.0F},
        {"a niche's edge on the wall", kNicheEdge, kWallDark, 3.0F},
        {"an outline's core on its halo before the window", kOutline,
         ui::over(kNight.with_alpha(0.55F), window), 3.0F},
        {"the hatch beside its lines", kHatch, ui::hex(0xfff1d6), 3.0F},
    };
    for (const Pair& pair : kPairs)
        EXPECT_GE(ui::contrast(pair.words, pair.ground), pair.least) << pair.name;
}

TEST(Design, HasTargetsOfTwentyMillimetres) {
    EXPECT_GE(double{kLeastTarget * kMmPerU}, kLeastTargetMm) << "the ends of a stepper";
}

TEST(Design, WritesCapitalsOfSevenTenthsOfADegree) {
    constexpr double kCapFraction = 0.719;  // of an em, the smallest of the families: Noto
    constexpr double kDistanceMm = 600.0;
    const double cap_mm = double{kLeastTextSize} * double{kMmPerU} * kCapFraction;
    EXPECT_GE(cap_mm, kDistanceMm * 0.012217) << "tan of 0.7 degrees";
}

TEST(Icons, AreAllDrawnInWordsThatCanBeRead) {
    for (int icon = 0; icon < kIconCount; ++icon) {
        ui::Sketch sketch;
        add_icon(sketch, static_cast<Icon>(icon), vec2(0.0F), 64.0F, kInk);
        EXPECT_FALSE(sketch.items.empty()) << icon;
        for (const ui::SketchItem& item : sketch.items) {
            const std::string& path = std::get<ui::Shape>(item).path;
            EXPECT_TRUE(ui::read_path(path)) << path;
        }
    }
}

}  // namespace
}  // namespace onggi::screens::design

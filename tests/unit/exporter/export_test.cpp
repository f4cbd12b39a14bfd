#include "game/exporter/export.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/refusal.h"

namespace onggi::exporter {
namespace {

TEST(ExportKindOf, KnowsGlbStlAnd3mfInAnyCase) {
    for (const char* path : {"pot.glb", "out/Pot.GLB", "a.b.glb", "pot.stl.glb"}) {
        const Result<ExportKind> kind = export_kind_of(path);
        ASSERT_TRUE(kind) << path;
        EXPECT_EQ(*kind, ExportKind::kGlb);
    }
    EXPECT_EQ(*export_kind_of("pot.Stl"), ExportKind::kStl);
    EXPECT_EQ(*export_kind_of("pot.3MF"), ExportKind::k3mf);
}

TEST(ExportKindOf, RejectsOtherEndingsAndNamesThoseKnown) {
    for (const char* path : {"pot.3md", "pot", "", ".glb", "glb", "pot.glb.", "pot.gltf"}) {
        const Result<ExportKind> kind = export_kind_of(path);
        ASSERT_FALSE(kind) << path;
        EXPECT_EQ(kind.error().kind, ErrorKind::kBadInput);
        EXPECT_EQ(kind.error().message,
                  std::string(path) + ": expected a name that ends in .glb, .stl, .3mf or .usdz");
    }
}

std::string refusal(double height_mm, const std::vector<float>& radii_mm) {
    return test::refusal(encode_pot(pot_file(rings_of(height_mm, radii_mm)), ExportKind::kGlb));
}

TEST(ExportPot, RejectsAnInvalidPot) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(refusal(200.0, {60.0F, 60.0F}), "accepted");
    EXPECT_EQ(refusal(200.0, {}), "pot: expected 1 to 200000 rings of clay, found 0");
    EXPECT_EQ(refusal(0.0, {60.0F}), "pot: expected a height of 1 to 2000 mm, found 0");
    EXPECT_EQ(refusal(std::numeric_limits<double>::infinity(), {60.0F}),
              "pot: expected a height of 1 to 2000 mm, found inf");
    EXPECT_EQ(refusal(200.0, {60.0F, nan}),
              "pot: ring 1: expected an outer radius of 0.1 to 1000 mm, found nan");
    EXPECT_EQ(refusal(200.0, {60.0F, 0.0F}),
              "pot: ring 1: expected an outer radius of 0.1 to 1000 mm, found 0");
    EXPECT_EQ(refusal(200.0, {-1.0F}), "pot: ring 0: expected an outer radius of 0.1 to 1000 mm, found -1");
}

TEST(ExportPot, MakesSoundNumbersAtTheLimitsOfAPot) {
    for (const double height_mm : {1.0, 2000.0}) {
        for (const float radius_mm : {0.1F, 1000.0F}) {
            EXPECT_EQ(refusal(height_mm, std::vector<float>(200000, radius_mm)), "accepted");
            const std::vector<float> radii_mm{radius_mm};
            EXPECT_TRUE(encode_pot(pot_file(rings_of(height_mm, radii_mm)), ExportKind::kStl))
                << "which refuses triangles without area";
        }
    }
}

}  // namespace
}  // namespace onggi::exporter

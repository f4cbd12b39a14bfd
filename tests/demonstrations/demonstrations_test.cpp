// The bundled demonstrations: each replays to the bit, yields the intended pot, is short enough to watch, and
// exports as a sound solid.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "game/app/command_line/performance.h"
#include "game/app/replay/replay.h"
#include "game/clay/studio/pot.h"
#include "game/exporter/pot_solid.h"
#include "game/exporter/studio_export.h"
#include "tests/support/mesh_check.h"
#include "tests/support/places.h"

namespace onggi {
namespace {

constexpr double kShortestS = 30.0;
constexpr double kLongestS = 60.0;

struct Expected {
    const char* name;
    double height_mm;
    double widest_mm;
    clay::ClayBody body = clay::ClayBody::kStoneware;
    clay::studio::Cause fails_by = clay::studio::Cause::kNone;
};

void PrintTo(const Expected& expected, std::ostream* out) {
    *out << expected.name;
}

class Demonstration : public testing::TestWithParam<Expected> {
  protected:
    // Returns the session; fails the test and returns an empty one if it cannot be loaded.
    [[nodiscard]] static Result<app::LoadedSession> loaded() {
        auto session = app::load_session(
            test::in_checkout(fmt::format("assets/demonstrations/{}.onggi", GetParam().name)));
        EXPECT_TRUE(session) << (session ? "" : session.error().message);
        return session;
    }
};

TEST_P(Demonstration, ReplaysToTheBitWithinTheTimeAVisitorWatches) {
    auto session = loaded();
    ASSERT_TRUE(session);
    EXPECT_TRUE(session->session.is_complete());
    const double seconds =
        static_cast<double>(session->session.tick_count()) * session->start.parameters.dt_s();
    EXPECT_GE(seconds, kShortestS);
    EXPECT_LE(seconds, kLongestS);
    const auto difference =
        app::find_difference(session->session, std::move(session->start), session->decoration);
    EXPECT_FALSE(difference) << "from tick " << (difference ? difference->first_tick : 0) << ": "
                             << (difference ? difference->what : "")
                             << "; where the clay is meant to differ, see assets/demonstrations/README.md";
}

TEST_P(Demonstration, LeavesItsPotAsASoundSolid) {
    auto session = loaded();
    ASSERT_TRUE(session);
    haptic::HapticState& state = session->start.state;
    ASSERT_NE(state.studio(), nullptr);
    record::SessionCursor hand(session->session);
    for (std::uint64_t tick = 0; tick < session->session.tick_count(); ++tick)
        haptic::tick(state, hand.at(tick), session->start.parameters);

    const Expected& expected = GetParam();
    const clay::StudioClay& clay = *state.studio();
    const auto pot = clay::measure_pot(clay.rings(), clay.lump().body);
    EXPECT_EQ(clay.lump().body, expected.body);
    EXPECT_EQ(clay.failure().cause, expected.fails_by) << clay::sentence(clay.failure());
    const bool fails = expected.fails_by != clay::studio::Cause::kNone;
    EXPECT_EQ(clay.ledger_error_mm3(), 0.0);
    EXPECT_NEAR(pot.height_mm, expected.height_mm, 4.0);
    EXPECT_NEAR(pot.widest_mm, expected.widest_mm, 4.0);
    if (!fails) {
        EXPECT_GT(pot.thinnest_wall_mm, 3.0);
        EXPECT_LT(clay.load_index(), 0.5) << "a pot to show stands with room to spare";
    }

    for (const auto stage : {clay::Firing::kWet, clay::Firing::kGlaze}) {
        const auto bytes = exporter::encode_pot(exporter::pot_file(clay, stage), exporter::ExportKind::kGlb);
        ASSERT_TRUE(bytes) << bytes.error().message;
        const auto file = support::read_glb(*bytes);
        ASSERT_TRUE(file) << file.error().message;
        const double metres = 1e-3 * clay::shrunk_scale(clay.lump().body, stage);
        support::ExpectedPot solid;
        solid.volume_m3 = clay.volume_mm3() * metres * metres * metres;
        solid.volume_tolerance = 1e-6;
        solid.height_m = clay.height_mm() * metres;
        solid.max_radius_m = 0.5 * pot.widest_mm * metres;
        solid.radius_tolerance_m = 6e-4;
        solid.off_axis_m = 2e-3;
        if (fails) solid.min_normal_agreement = -1.0;  // a heap has folds
        EXPECT_EQ(support::find_faults(file->mesh, solid), std::vector<std::string>{});
        EXPECT_LE(file->mesh.indices.size() / 3, exporter::kMaxTriangles);
    }
}

constexpr clay::ClayBody kPorcelain = clay::ClayBody::kPorcelain;
INSTANTIATE_TEST_SUITE_P(Bundled, Demonstration,
                         testing::Values(Expected{"cylinder", 183.4, 115.2}, Expected{"bowl", 118.0, 217.6},
                                         Expected{"vase", 190.7, 143.0},
                                         Expected{"moon_jar_half", 90.0, 170.0, kPorcelain},
                                         Expected{"moon_jar", 171.2, 168.9, kPorcelain},
                                         Expected{"collapse", 130.7, 300.0, clay::ClayBody::kStoneware,
                                                  clay::studio::Cause::kSpin}),
                         [](const auto& sample) { return std::string(sample.param.name); });

TEST(MoonJar, IsTwoHalvesWithASeamThatIsALittleVisible) {
    auto jar = app::load_session(test::in_checkout("assets/demonstrations/moon_jar.onggi"));
    ASSERT_TRUE(jar) << jar.error().message;
    ASSERT_NE(jar->start.state.studio(), nullptr);
    const clay::StudioClay& joined = *jar->start.state.studio();
    const auto& rings = joined.rings();
    // Before the rib: the ridge at 90 mm stands out from the wall 4 mm to either side.
    const auto outer_at = [&](double y) { return rings.outer_mm[clay::studio::Rings::at(rings.ring_at(y))]; };
    double ridge = 0.0;
    for (double y = 88.0; y < 92.0; y += 0.1)
        ridge = std::max(ridge, outer_at(y));
    EXPECT_GT(ridge - 0.5 * (outer_at(85.0) + outer_at(95.0)), 0.2);
    EXPECT_NEAR(joined.lump().mass_g, 1600.0, 1e-9);
    EXPECT_GT(joined.ledger().trimmings_mm3, 0.0);
    EXPECT_EQ(joined.ledger_error_mm3(), 0.0);
}

}  // namespace
}  // namespace onggi

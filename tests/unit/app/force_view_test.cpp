// The force view of a snapshot: the ends of the arrows, and the highlighted rings.
#include "game/app/kiosk/presentation/force_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>

#include "game/haptic/job.h"
#include "tests/support/scripted_device.h"
#include "tests/unit/haptic/studio_hand.h"

namespace onggi::app {
namespace {

// A camera far in front, one pixel a mm, y down.
Sight from_the_front() {
    return {.project = [](const dvec3& place_mm) { return std::optional(dvec2(place_mm.x, -place_mm.y)); },
            .towards_eye = [](const dvec3&) { return dvec3(0.0, 0.0, 1.0); }};
}

haptic::Snapshot touching(const pot::Pot& shape) {
    haptic::Snapshot snapshot;
    snapshot.pot = &shape;
    snapshot.tool.position_mm = {69.0, 100.0, 0.0};
    snapshot.tool.radius_mm = 10.0;
    snapshot.result.forces.contacts = 3;
    snapshot.result.forces.stiffness_n = {0.3, 0.0, 0.0};
    snapshot.result.forces.viscosity_n = {0.0, 0.08, 0.0};
    snapshot.result.forces.friction_n = {0.0, 0.0, -0.2};
    return snapshot;
}

TEST(Forces, AreThePapersThreeAndTheirSum) {
    pot::Pot shape;
    const Forces forces = forces_of(touching(shape).result.forces);
    EXPECT_EQ(forces[0], dvec3(0.3, 0.0, 0.0));
    EXPECT_EQ(forces[1], dvec3(0.0, 0.08, 0.0));
    EXPECT_EQ(forces[2], dvec3(0.0, 0.0, -0.2));
    EXPECT_EQ(forces[3], dvec3(0.3, 0.08, -0.2));
}

TEST(Forces, BeginWhereTheToolTouches) {
    EXPECT_EQ(touched_mm({69.0, 100.0, 0.0}, 10.0, {0.3, 0.0, 0.0}), dvec3(59.0, 100.0, 0.0));
    EXPECT_EQ(touched_mm({0.0, 60.0, 0.0}, 8.0, {0.0, 2.0, 0.0}), dvec3(0.0, 52.0, 0.0));
    EXPECT_EQ(touched_mm({69.0, 100.0, 0.0}, 10.0, dvec3(0.0)), dvec3(69.0, 100.0, 0.0));
}

TEST(Forces, AreNeverLongerThanAnArrowMayBe) {
    pot::Pot shape;
    haptic::Snapshot snapshot = touching(shape);
    ForceView view;
    view.look(snapshot, 1.0 / 60.0);
    snapshot.result.forces.stiffness_n = {60.0, 0.0, 0.0};
    snapshot.result.second_forces = snapshot.result.forces;
    snapshot.result.second_forces.stiffness_n = {-90.0, 0.0, 0.0};
    for (int frame = 2; frame <= 60; ++frame) {
        view.look(snapshot, frame / 60.0);
        const screens::ForceFrame shown = view.frame(snapshot, from_the_front(), true);
        for (const screens::ForceTouch& touch : shown.touches)
            for (const screens::ForceArrow& arrow : touch.arrows)
                EXPECT_LE(glm::distance(arrow.from_px, arrow.to_px), ForceView::kFullArrowMm + 1e-3)
                    << "frame " << frame;
    }
}

TEST(Forces, AreDrawnInTheirPlaces) {
    pot::Pot shape;
    const haptic::Snapshot snapshot = touching(shape);
    ForceView view;
    for (int frame = 1; frame <= 240; ++frame)  // until the display has settled
        view.look(snapshot, frame / 60.0);
    // 0.37 N at most: the plot is 0.5 N high, and so is an arrow of 80 mm.
    EXPECT_NEAR(view.mm_per_n(), 160.0, 1e-6);
    const screens::ForceFrame frame = view.frame(snapshot, from_the_front(), true);
    ASSERT_EQ(frame.touches.size(), 1U);
    const auto& arrows = frame.touches[0].arrows;
    const auto expect_arrow = [&](screens::Force force, vec2 to_px) {
        const screens::ForceArrow& arrow = arrows[static_cast<std::size_t>(force)];
        EXPECT_TRUE(arrow.shown);
        EXPECT_NEAR(arrow.from_px.x, 59.0F, 1e-3F);
        EXPECT_NEAR(arrow.from_px.y, -100.0F, 1e-3F);
        EXPECT_NEAR(arrow.to_px.x, to_px.x, 1e-2F) << static_cast<int>(force);
        EXPECT_NEAR(arrow.to_px.y, to_px.y, 1e-2F) << static_cast<int>(force);
    };
    expect_arrow(screens::Force::kStiffness, {59.0F + 48.0F, -100.0F});
    expect_arrow(screens::Force::kViscosity, {59.0F, -112.8F});
    expect_arrow(screens::Force::kFriction, {59.0F, -100.0F});
    expect_arrow(screens::Force::kTotal, {59.0F + 48.0F, -112.8F});
    // The friction goes straight into the picture, which an arrow cannot show.
    EXPECT_NEAR(arrows[2].seen, 0.0F, 1e-6F);
    EXPECT_FALSE(arrows[2].towards);
    EXPECT_NEAR(arrows[0].seen, 1.0F, 1e-6F);
    EXPECT_NEAR(frame.size_n[0], 0.3, 1e-6);
    EXPECT_NEAR(frame.size_n[3], std::sqrt(0.09 + 0.0064 + 0.04), 1e-6);
}

TEST(Forces, AreShownOnlyDuringATouch) {
    pot::Pot shape;
    haptic::Snapshot snapshot = touching(shape);
    ForceView view;
    view.look(snapshot, 1.0);
    snapshot.result.forces = {};
    view.look(snapshot, 1.02);
    const screens::ForceFrame frame = view.frame(snapshot, from_the_front(), true);
    EXPECT_TRUE(frame.touches.empty());
    EXPECT_EQ(frame.size_n[3], 0.0);
}

// The job's own snapshots, tick by tick: look(snapshot, touching) looks at each, and counts those of clay
// that is touched.
template <typename Look>
void expect_of_snapshots(haptic::HapticState start, haptic::ToolDevices devices, int ticks, Look&& look) {
    haptic::HapticWork work(std::move(start), {}, std::move(devices), {});
    jobs::Period period{.dt_s = 0.001};
    int touching = 0;
    for (int k = 0; k < ticks && !testing::Test::HasFatalFailure(); ++k) {
        SCOPED_TRACE(k);
        ASSERT_TRUE(work.tick(period));
        ++period.index;
        ++period.tick;
        haptic::TickRecord record;
        while (work.take_record(record)) {
        }
        const haptic::Snapshot& snapshot = work.newest_snapshot();
        ASSERT_EQ(snapshot.periods, static_cast<std::uint64_t>(k) + 1U);
        look(snapshot, touching);
    }
    EXPECT_GT(touching, 500);
}

TEST(LitRings, AreThoseInContactOfThePapersClay) {
    const auto look = [](const haptic::Snapshot& snapshot, int& touching) {
        // A shape copied a few ticks ago may differ by a ring.
        if (snapshot.pot_stamp.tick != snapshot.tick) return;
        const RingSpan lit = rings_touched(*snapshot.pot, snapshot.result.forces);
        ASSERT_EQ(lit.size(), snapshot.result.forces.contacts);
        touching += lit.size() > 0 ? 1 : 0;
    };
    expect_of_snapshots(haptic::HapticState(), std::make_unique<test::ScriptedDevice>(), 2500, look);
}

TEST(LitRings, ReachOverTheRingsThatAStudioHandTouches) {
    const auto look = [](const haptic::Snapshot& snapshot, int& touching) {
        const clay::ContactForces& forces = snapshot.result.forces;
        if (forces.contacts == 0) return;
        ++touching;
        ASSERT_LT(forces.contact_low_mm, forces.contact_high_mm);
        ASSERT_GE(forces.contact_low_mm, 0.0);
        // A hand touches nothing farther away than its radius, except with its shaft.
        ASSERT_GE(forces.contact_high_mm, snapshot.tool.position_mm.y - snapshot.tool.radius_mm - 2.0);
        // The shape is copied in pieces while rings flow: some may be off. Between a hand inside
        // and its shaft above it there are rings that neither touches.
        const RingSpan lit = rings_touched(*snapshot.pot, forces);
        const double off = 6.0 + 0.2 * forces.contacts;
        ASSERT_GE(lit.size(), forces.contacts - off);
        if (snapshot.tool.shaft_mm > 0.0) return;
        ASSERT_LE(lit.size(), forces.contacts + off);
    };
    expect_of_snapshots(test::studio_start(), std::make_unique<test::StudioHand>(1000.0), 6000, look);
}

TEST(LitRings, AreAsManyLinesAsCanBeTold) {
    pot::Pot shape;
    shape.height_mm = 200.0;
    shape.outer_mm.assign(2000, 60.0F);
    haptic::Snapshot snapshot = touching(shape);
    snapshot.result.forces.contact_low_mm = 99.7;
    snapshot.result.forces.contact_high_mm = 100.0;
    ForceView view;
    view.look(snapshot, 1.0);
    const auto lines_of = [&] {
        const screens::ForceFrame frame = view.frame(snapshot, from_the_front(), true);
        return frame.touches.at(0).rings_px;
    };
    ASSERT_EQ(lines_of().size(), 3U) << "one for each ring in contact";
    EXPECT_NEAR(lines_of()[0].front().x, -60.0F, 1e-3F);
    EXPECT_NEAR(lines_of()[0].back().x, 60.0F, 1e-3F);
    EXPECT_NEAR(lines_of()[0].front().y, -99.75F, 1e-3F);
    snapshot.result.forces.contact_low_mm = 90.0;
    snapshot.result.forces.contact_high_mm = 110.0;
    EXPECT_EQ(lines_of().size(), 12U) << "of two hundred";
}

}  // namespace
}  // namespace onggi::app

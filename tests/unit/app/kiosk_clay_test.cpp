// Snapshots as from the haptic loop: the last visitor's clay for some more frames, then the new one.
#include "game/app/kiosk/visit/visit_wheel.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "game/app/command_line/performance.h"
#include "game/haptic/job.h"
#include "game/haptic/simulated_device.h"
#include "tests/support/places.h"

namespace onggi::app {
namespace {

using clay::studio::Cause;
using kiosk::Warning;

// A lump as wide as that at its foot, or an open pot.
haptic::PotCopy clay_of(std::uint64_t run, double height_mm, double foot_mm, bool is_open) {
    constexpr int kRings = 60;
    haptic::PotCopy copy{.pot = {}, .stamp = {.run = run}};
    pot::Pot& pot = copy.pot;
    pot.height_mm = height_mm;
    pot.floor_mm = is_open ? 8.0 : height_mm;
    for (int ring = 0; ring < kRings; ++ring) {
        pot.outer_mm.push_back(static_cast<float>(foot_mm));
        if (is_open) pot.inner_mm.push_back(ring > 6 ? static_cast<float>(foot_mm - 8.0) : 0.0F);
        pot.top_mm.push_back(static_cast<float>(height_mm * (ring + 1) / kRings));
    }
    return copy;
}

haptic::Snapshot seen(const haptic::PotCopy& shape, std::uint64_t tick) {
    haptic::Snapshot snapshot;
    snapshot.run = shape.stamp.run;
    snapshot.states_put = shape.stamp.states_put;
    snapshot.tick = tick;
    snapshot.pot = &shape.pot;
    snapshot.pot_stamp = shape.stamp;
    return snapshot;
}

haptic::Snapshot sunken(const haptic::PotCopy& shape, std::uint64_t tick, double load = 1.1) {
    haptic::Snapshot snapshot = seen(shape, tick);
    snapshot.load.failure.cause = Cause::kWeight;
    snapshot.load.index = load;
    return snapshot;
}

// It expects the first lump.
struct KioskClayTest : testing::Test {
    KioskClayTest() { clay.expect_lump(1); }
    KioskClay clay;
};

TEST_F(KioskClayTest, SaysOnceThatThePotGaveWayAndWhenThatBegan) {
    const haptic::PotCopy standing = clay_of(1, 100.0, 50.0, true);
    EXPECT_FALSE(clay.look(seen(standing, 4000), Warning::kNone)->gave_way);
    const haptic::PotCopy sagging = clay_of(1, 95.0, 51.0, true);
    EXPECT_FALSE(clay.look(sunken(sagging, 8000), Warning::kNone)->gave_way) << "a little is no failure";
    const haptic::PotCopy low = clay_of(1, 75.0, 60.0, true);
    EXPECT_EQ(clay.look(sunken(low, 20000), Warning::kNone)->gave_way, Warning::kThin);
    EXPECT_EQ(clay.began_to_fail_tick(), 8000U) << "two seconds before 20000 it was failing already";
    EXPECT_FALSE(clay.look(sunken(low, 20100), Warning::kNone)->gave_way);
}

TEST_F(KioskClayTest, TakesABowlThatSpinsWideForAFailureThoughItHardlySinks) {
    const haptic::PotCopy standing = clay_of(1, 100.0, 100.0, true);
    (void)clay.look(seen(standing, 4000), Warning::kNone);
    EXPECT_FALSE(clay.look(sunken(clay_of(1, 99.0, 108.0, true), 5000), Warning::kNone)->gave_way);
    EXPECT_TRUE(clay.look(sunken(clay_of(1, 97.0, 113.0, true), 5100), Warning::kNone)->gave_way);
    EXPECT_EQ(clay.began_to_fail_tick(), 5000U);
}

TEST_F(KioskClayTest, JudgesARestoredStateByItsOwnHeight) {
    haptic::PotCopy there = clay_of(1, 80.0, 50.0, true);
    clay.expect_state(seen(there, 9000));
    there.stamp.states_put = 1;
    EXPECT_FALSE(clay.look(sunken(there, 4000), Warning::kNone)->gave_way);
    haptic::PotCopy wider = clay_of(1, 79.0, 53.0, true);
    wider.stamp.states_put = 1;
    EXPECT_FALSE(clay.look(sunken(wider, 4100), Warning::kNone)->gave_way);
    haptic::PotCopy widest = clay_of(1, 78.0, 57.0, true);
    widest.stamp.states_put = 1;
    EXPECT_TRUE(clay.look(sunken(widest, 4200), Warning::kNone)->gave_way);
}

TEST_F(KioskClayTest, LetsClayThatWasSavedBePressedDownAndDrawnOut) {
    const haptic::PotCopy standing = clay_of(1, 100.0, 50.0, true);
    (void)clay.look(seen(standing, 4000), Warning::kNone);
    (void)clay.look(sunken(clay_of(1, 97.0, 51.0, true), 5000), Warning::kNone);
    EXPECT_FALSE(clay.look(sunken(clay_of(1, 95.0, 52.0, true), 6000, 0.5), Warning::kNone)->gave_way);
    EXPECT_EQ(clay.began_to_fail_tick(), 0U);
    EXPECT_FALSE(clay.look(sunken(clay_of(1, 70.0, 70.0, true), 9000, 0.5), Warning::kNone)->gave_way)
        << "by the visitor's hand";
    EXPECT_FALSE(clay.look(sunken(clay_of(1, 69.0, 71.0, true), 9100), Warning::kNone)->gave_way);
    EXPECT_TRUE(clay.look(sunken(clay_of(1, 50.0, 80.0, true), 9200), Warning::kNone)->gave_way);
}

// The real clay in the real loop, on a clock of its own: a wide bowl, softened, and the wheel at the speed
// that the kiosk's highest step asks for.
TEST_F(KioskClayTest, SeesARealBowlSpinApartWhileItStillStandsHigh) {
    auto loaded = load_session(test::in_checkout("assets/demonstrations/collapse.onggi"));
    ASSERT_TRUE(loaded) << loaded.error().message;
    haptic::HapticState& bowl = loaded->start.state;
    record::SessionCursor hand(loaded->session);
    constexpr std::uint64_t kDrawnWide = 27'250;  // of 500 a second; then its pedal goes down
    for (std::uint64_t tick = 0; tick < kDrawnWide; ++tick)
        haptic::tick(bowl, hand.at(tick), loaded->start.parameters);
    bowl.studio()->set_liquidity(0.8);
    bowl.ticks = 0;
    const double standing_mm = bowl.height_mm();
    haptic::HapticParameters parameters;
    auto device = std::make_unique<haptic::SimulatedDevice>();
    device->set_target(
        {.position_mm = {250.0, 300.0, 0.0}, .wheel_button = true, .wheel_speed_rev_min = 180.0});
    haptic::HapticWork work(bowl, parameters, std::move(device), {});
    jobs::Period period{.dt_s = parameters.dt_s()};
    clay.expect_lump(0);
    std::optional<Warning> gave_way;
    haptic::TickRecord record;
    while (!gave_way && period.tick < 8000) {
        for (int tick = 0; tick < 16; ++tick, ++period.tick, ++period.index)
            ASSERT_TRUE(work.tick(period));
        while (work.take_record(record)) {
        }
        if (const auto news = clay.look(work.newest_snapshot(), Warning::kNone)) gave_way = news->gave_way;
    }
    EXPECT_EQ(gave_way, Warning::kFast);
    EXPECT_GT(work.state().height_mm(), 0.9 * standing_mm) << "it hardly sank";
    EXPECT_LT(period.tick, 2500U) << "of a second each thousand";
}

TEST_F(KioskClayTest, IsSilentWhileTheEarlierStateIsOnItsWay) {
    const haptic::PotCopy standing = clay_of(1, 100.0, 50.0, true);
    (void)clay.look(seen(standing, 4000), Warning::kNone);
    const haptic::PotCopy low = clay_of(1, 60.0, 60.0, true);
    ASSERT_TRUE(clay.look(sunken(low, 8000), Warning::kNone)->gave_way);
    clay.expect_state(sunken(low, 8100));
    EXPECT_FALSE(clay.look(sunken(low, 8200), Warning::kNone)) << "what sank is still there";
    // The numbers belong to the earlier state, the rings not yet.
    haptic::Snapshot between = seen(low, 4000);
    between.states_put = 1;
    EXPECT_FALSE(clay.look(between, Warning::kNone));
    haptic::PotCopy before = clay_of(1, 98.0, 50.0, true);
    before.stamp.states_put = 1;
    const auto news = clay.look(seen(before, 4010), Warning::kNone);
    ASSERT_TRUE(news);
    EXPECT_FALSE(news->gave_way);
    // A second collapse is reported again.
    haptic::PotCopy again = clay_of(1, 60.0, 60.0, true);
    again.stamp.states_put = 1;
    EXPECT_TRUE(clay.look(sunken(again, 9000), Warning::kNone)->gave_way);
}

TEST_F(KioskClayTest, GoesOnWhereTheEarlierStateDoesNotCome) {
    const haptic::PotCopy standing = clay_of(1, 100.0, 50.0, true);
    (void)clay.look(seen(standing, 4000), Warning::kNone);
    clay.expect_state(seen(standing, 4000));
    EXPECT_FALSE(clay.look(seen(standing, 4001), Warning::kNone));
    clay.expect_nothing();
    EXPECT_TRUE(clay.look(seen(standing, 4002), Warning::kNone));
}

TEST_F(KioskClayTest, TeachesByTheNewLumpAndNotByTheLastVisitorsPot) {
    clay.expect_lump(4);
    const haptic::PotCopy old_pot = clay_of(4, 140.0, 40.0, true);
    EXPECT_GT(clay.look(seen(old_pot, 90000), Warning::kNone)->steps_done, 1);
    clay.expect_lump(5);
    EXPECT_FALSE(clay.look(seen(old_pot, 90001), Warning::kNone));
    haptic::Snapshot between = seen(old_pot, 1);
    between.run = 5;
    EXPECT_FALSE(clay.look(between, Warning::kNone)) << "the rings are still the old pot's";
    const haptic::PotCopy lump = clay_of(5, 75.0, 60.0, false);
    const auto news = clay.look(seen(lump, 2), Warning::kNone);
    ASSERT_TRUE(news);
    EXPECT_EQ(news->steps_done, 0);
}

}  // namespace
}  // namespace onggi::app

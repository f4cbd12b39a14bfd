// The haptic loop with the studio's clay: its snapshots and records, and that a replay gives the same bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "game/haptic/job.h"
#include "game/haptic/simulated_device.h"
#include "game/record/session_format.h"
#include "tests/unit/haptic/studio_hand.h"

namespace onggi::haptic {
namespace {

constexpr double kStudioRateHz = 1000.0;

bool is_hashed(const HapticState& state) {
    return state.ticks % record::kHashInterval == 0;
}

struct StudioLoop {
    explicit StudioLoop(const HapticJobOptions& options = {})
        : work(test::studio_start(), HapticParameters{}, std::make_unique<test::StudioHand>(kStudioRateHz),
               options) {}

    void run(std::uint64_t ticks) {
        for (std::uint64_t k = 0; k < ticks; ++k) {
            ASSERT_TRUE(work.tick(period));
            ++period.index;
            ++period.tick;
            TickRecord record;
            while (work.take_record(record))
                records.push_back(record);
            if (is_hashed(work.state())) hashes.push_back(work.state().hash());
        }
    }

    HapticWork work;
    jobs::Period period{.dt_s = 1.0 / kStudioRateHz};
    std::vector<TickRecord> records;
    std::vector<std::uint64_t> hashes;  // after every thousandth tick
};

TEST(StudioLoop, ReplaysFromItsRecordsToTheBit) {
    StudioLoop loop({.run_ticks = 9000, .repeat = true});
    loop.run(12'000);
    HapticState replayed = test::studio_start();
    std::size_t hash = 0;
    for (const TickRecord& record : loop.records) {
        if ((record.flags & TickRecord::kFreshLump) != 0) replayed.restart_from(test::studio_start());
        const TickResult result = tick(replayed, record.tool, HapticParameters{});
        ASSERT_EQ(result.forces.total_n(), record.force_n) << "tick " << record.tick;
        if (!is_hashed(replayed)) continue;
        ASSERT_LT(hash, loop.hashes.size());
        ASSERT_EQ(loop.hashes[hash++], replayed.hash());
    }
    EXPECT_EQ(hash, 12U);
    EXPECT_EQ(replayed.hash(), loop.work.state().hash());
}

TEST(StudioLoop, AFreshLumpIsTheLumpItBeganWith) {
    StudioLoop loop({.run_ticks = 9000, .repeat = true});
    loop.run(9000 + 1234);
    StudioLoop once;
    once.run(1234);
    EXPECT_EQ(loop.work.state().hash(), once.work.state().hash());
}

// Compares the picture's shape with the clay.
void expect_shape_of(const pot::Pot& shape, const clay::StudioClay& clay, double within_mm) {
    const auto& outer = shape.outer_mm;
    const auto& inner = shape.inner_mm;
    const auto& top = shape.top_mm;
    ASSERT_EQ(outer.size(), static_cast<std::size_t>(shape.ring_count()));
    ASSERT_EQ(inner.size(), outer.size());
    ASSERT_EQ(top.size(), outer.size());
    ASSERT_EQ(shape.centre_mm.size(), outer.size());
    ASSERT_EQ(shape.load_index.size(), outer.size());
    ASSERT_NEAR(shape.height_mm, clay.height_mm(), within_mm);
    ASSERT_NEAR(shape.floor_mm, clay.floor_mm(), 1.0);
    float below = 0.0F;
    for (std::size_t i = 0; i < outer.size(); ++i) {
        ASSERT_GT(top[i], below) << "ring " << i;
        const double middle = 0.5 * static_cast<double>(below + top[i]);
        below = top[i];
        const int ring = clay.rings().ring_at(middle);
        const auto at = static_cast<std::size_t>(ring);
        ASSERT_NEAR(static_cast<double>(outer[i]), clay.outer_mm()[at], within_mm)
            << "at " << middle << " mm";
        if (std::abs(middle - clay.floor_mm()) > 1.0) {
            ASSERT_NEAR(static_cast<double>(inner[i]), clay.inner_mm()[at], within_mm) << "at " << middle;
        }
    }
}

TEST(StudioLoop, HandsTheWholePotOverTwiceAFrame) {
    StudioLoop loop;
    const pot::Pot* shape = loop.work.newest_snapshot().pot;
    ASSERT_NE(shape, nullptr);
    expect_shape_of(*shape, *test::studio_start().studio(), 1e-4);
    int shapes = 0;
    std::uint64_t last = 0;
    for (int k = 0; k < 9000; ++k) {
        loop.run(1);
        const Snapshot& snapshot = loop.work.newest_snapshot();
        ASSERT_EQ(snapshot.tick, static_cast<std::uint64_t>(k + 1)) << "cheap values come every tick";
        if (snapshot.pot_stamp.tick == last) continue;
        last = snapshot.pot_stamp.tick;
        ASSERT_EQ(last, snapshot.tick);
        ++shapes;
        if (shapes % 10 == 0) expect_shape_of(*snapshot.pot, *loop.work.state().studio(), 1e-4);
    }
    EXPECT_GE(shapes, 900) << "two a frame";
    // Two hands that hold a wall no longer squeeze it higher, so that few rings are split.
    EXPECT_GT(loop.work.state().studio()->splits(), 10U) << "rings came meanwhile";
}

TEST(StudioLoop, ReportsBothHandsAndTheClaysLoad) {
    StudioLoop loop;
    loop.run(3000);
    const Snapshot& snapshot = loop.work.newest_snapshot();
    EXPECT_EQ(snapshot.result.side, tool::Side::kIn);
    EXPECT_GT(snapshot.result.forces.contacts, 0);
    EXPECT_FALSE(snapshot.result.has_second);
    EXPECT_NEAR(snapshot.wheel_speed_rad_s, 4.0 * 3.14159, 0.5);
    EXPECT_TRUE(snapshot.wheel_turning);
    EXPECT_GT(snapshot.load.index, 0.0);
    EXPECT_LT(snapshot.load.index, 1.0);
    EXPECT_EQ(snapshot.load.failure.cause, clay::studio::Cause::kNone);
    EXPECT_EQ(snapshot.on_wheel_mm3, loop.work.state().studio()->volume_mm3());
    EXPECT_EQ(snapshot.hand_film, loop.work.state().studio()->film());
}

TEST(StudioLoop, GivesTheDentsOfAStandingWheelRoundThePot) {
    HapticState state = test::studio_start();
    const HapticParameters parameters;
    // Pressed from +X at 20 mm while the wheel stands.
    for (int k = 0; k < 2000; ++k)
        tick(state, {.position_mm = {59.0, 20.0, 0.0}, .radius_mm = 12.0}, parameters);
    const pot::Pot shape = pot_of(state);
    ASSERT_EQ(shape.dents_mm.size(), static_cast<std::size_t>(kDentRows) * kDentSectors);
    const auto deepest = std::min_element(shape.dents_mm.begin(), shape.dents_mm.end());
    const auto at = static_cast<std::size_t>(deepest - shape.dents_mm.begin());
    EXPECT_LT(*deepest, -0.5F);
    EXPECT_TRUE(at % kDentSectors == 0 || at % kDentSectors == kDentSectors - 1) << at % kDentSectors;
    EXPECT_NEAR((static_cast<double>(at / kDentSectors) + 0.5) / kDentRows * shape.height_mm, 20.0, 2.0);
    EXPECT_TRUE(pot_of(test::studio_start()).dents_mm.empty());
}

TEST(StudioLoop, PutsTheStateOnTheWheelThatItIsGiven) {
    StudioLoop loop;
    loop.run(5000);
    HapticState earlier = test::studio_start();
    for (std::uint64_t k = 0; k < 2500; ++k)
        tick(earlier, test::studio_hand(k, kStudioRateHz), HapticParameters{});
    const std::uint64_t hash = earlier.hash();
    ASSERT_TRUE(loop.work.put(std::make_unique<HapticState>(earlier), 0));
    loop.records.clear();
    loop.run(1);
    ASSERT_EQ(loop.records.size(), 1U);
    EXPECT_EQ(loop.records[0].flags & TickRecord::kStatePut, TickRecord::kStatePut);
    EXPECT_EQ(loop.records[0].tick, 2500U);
    EXPECT_EQ(loop.work.newest_snapshot().states_put, 1U);
    ASSERT_EQ(earlier.hash(), hash);
    tick(earlier, loop.records[0].tool, HapticParameters{});
    EXPECT_EQ(loop.work.state().hash(), earlier.hash());
    loop.run(100);
    EXPECT_EQ(loop.work.state().ticks, 2601U);
    // A full queue refuses more, and loses none of the accepted ones.
    int taken = 0;
    while (loop.work.put(std::make_unique<HapticState>(earlier), 0))
        ++taken;
    EXPECT_GE(taken, 4);
    loop.run(1);
    EXPECT_EQ(loop.work.newest_snapshot().states_put, 1U + static_cast<std::uint64_t>(taken));
}

// A hand waits beside the pot while undo restores a state in which it was at work. With that state's memory
// of the hand it would appear to have passed through the walls and would go on pressing.
TEST(StudioLoop, DoesNotTakeAHandThatHasMovedOnForOneThatCameThroughTheWall) {
    const auto resting = [](const dvec3& place_mm) {
        auto device = std::make_unique<haptic::SimulatedDevice>();
        device->set_target({.position_mm = place_mm, .wheel_button = true});
        return device;
    };
    HapticParameters parameters;
    parameters.safety = haptics::limits_for(haptic::SimulatedDevice().capabilities());
    for (const double pressing_s : {3.0, 6.0}) {  // inside; outside, from +x
        HapticState at_work = test::studio_start();
        tool::Side side{};
        for (std::uint64_t k = 0; static_cast<double>(k) < pressing_s * kStudioRateHz; ++k)
            side = tick(at_work, test::studio_hand(k, kStudioRateHz), HapticParameters{}).side;
        ASSERT_EQ(side, pressing_s < 4.0 ? tool::Side::kIn : tool::Side::kOut);
        for (const dvec3& place_mm : {dvec3(145.0, 12.0, 142.0), dvec3(-150.0, 30.0, 1.0)}) {
            HapticWork work(test::studio_start(), parameters, resting(place_mm), {});
            ASSERT_TRUE(work.device().open());
            jobs::Period period{.dt_s = 1.0 / kStudioRateHz};
            ASSERT_TRUE(work.tick(period));
            ASSERT_TRUE(work.put(std::make_unique<HapticState>(at_work), 0));
            double largest_n = 0.0;
            for (int k = 0; k < 500; ++k) {
                ++period.index;
                ++period.tick;
                ASSERT_TRUE(work.tick(period));
                largest_n = std::max(largest_n, glm::length(work.newest_snapshot().result.limited_force_n));
            }
            EXPECT_EQ(work.newest_snapshot().states_put, 1U);
            EXPECT_EQ(largest_n, 0.0) << "at " << place_mm.x << ", " << pressing_s << " s";
            EXPECT_EQ(work.newest_snapshot().safety.speed_stops, 0U) << "the device was where it is";
            EXPECT_NEAR(work.state().height_mm(), at_work.height_mm(), 0.3);
        }
    }
}

// Undo followed by new clay yields new clay, however long the undo takes.
TEST(StudioLoop, LetsGoOfAStateOfTheLumpBefore) {
    StudioLoop loop;
    loop.run(100);
    ASSERT_TRUE(loop.work.send(Command::kFreshLump));
    ASSERT_TRUE(loop.work.put(std::make_unique<HapticState>(test::studio_start()), 0));
    loop.records.clear();
    loop.run(10);
    EXPECT_EQ(loop.work.newest_snapshot().states_put, 0U);
    EXPECT_EQ(loop.records[0].flags & TickRecord::kStatePut, 0U);
    EXPECT_EQ(loop.work.state().ticks, 10U);
    ASSERT_TRUE(loop.work.put(std::make_unique<HapticState>(test::studio_start()), 1));
    loop.run(1);
    EXPECT_EQ(loop.work.newest_snapshot().states_put, 1U);
}

}  // namespace
}  // namespace onggi::haptic

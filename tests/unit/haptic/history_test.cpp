// Undo: returns to any moment by replay, to the bit.
#include "game/haptic/history.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/files/read_file.h"
#include "game/record/session.h"
#include "game/tool/tool.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/haptic/studio_hand.h"

namespace onggi::haptic {
namespace {

constexpr double kHistoryRateHz = 500.0;
constexpr auto kTicks = static_cast<std::uint64_t>(test::kStudioHandSeconds * kHistoryRateHz);

HapticParameters parameters_at(double rate_hz) {
    HapticParameters parameters;
    parameters.set_rate_hz(rate_hz);
    return parameters;
}

// A wheel whose records a history follows, without a thread between them.
struct Wheel {
    explicit Wheel(const HistoryOptions& options = {}) : history(state, parameters, options) {}

    void tick(std::uint64_t hand_tick, std::uint32_t flags = 0) {
        tick(test::studio_hand(hand_tick, kHistoryRateHz), flags);
    }
    void tick(const tool::ToolState& tool, std::uint32_t flags = 0) {
        const TickResult result = haptic::tick(state, tool, parameters);
        history.add({.tick = static_cast<std::uint32_t>(state.ticks - 1),
                     .flags = flags,
                     .tool = state.tool,
                     .force_n = result.forces.total_n()});
    }
    void throw_until(std::uint64_t end) {
        while (state.ticks < end)
            tick(state.ticks);
    }

    HapticState state = test::studio_start();
    HapticParameters parameters = parameters_at(kHistoryRateHz);
    History history;
};

struct HistoryTest : testing::Test {
    Wheel wheel;
};

TEST_F(HistoryTest, HoldsTheClayThatIsOnTheWheel) {
    wheel.throw_until(kTicks);
    EXPECT_TRUE(wheel.history.is_whole());
    EXPECT_EQ(wheel.history.state().hash(), wheel.state.hash());
    EXPECT_EQ(wheel.history.checkpoint_count(), 10U) << "one a second, and the start";
}

TEST_F(HistoryTest, GoesBackToAnyTickToTheBit) {
    std::vector<std::uint64_t> hashes;
    while (wheel.state.ticks < kTicks) {
        if (wheel.state.ticks % 333 == 0) hashes.push_back(wheel.state.hash());
        wheel.tick(wheel.state.ticks);
    }
    for (std::size_t i = 0; i < hashes.size(); ++i)
        ASSERT_EQ(wheel.history.state_at(333 * i).value().hash(), hashes[i]) << "tick " << 333 * i;
}

TEST_F(HistoryTest, TellsTheMovesApart) {
    wheel.throw_until(kTicks);
    const auto moves = wheel.history.moves();
    ASSERT_EQ(moves.size(), 4U);
    EXPECT_EQ(moves[0].side, tool::Side::kIn) << "opened and widened";
    EXPECT_EQ(moves[1].side, tool::Side::kOut);
    EXPECT_EQ(moves[1].tool, tool::Tool::kHand);
    EXPECT_EQ(moves[2].tool, tool::Tool::kRib);
    EXPECT_TRUE(moves[3].is_cut);
    for (std::size_t i = 1; i < moves.size(); ++i)
        EXPECT_GE(moves[i].first_tick, moves[i - 1].end_tick);
}

TEST_F(HistoryTest, UndoesOneMoveAfterAnother) {
    wheel.throw_until(kTicks);
    const std::uint64_t cut = wheel.state.studio()->ledger().trimmings_mm3 > 0.0 ? 1 : 0;
    ASSERT_EQ(cut, 1U);
    std::vector<double> heights;
    for (std::uint64_t again = 0; const auto tick = wheel.history.before_last_move(); ++again) {
        // As the haptic loop does it: the state is put on the wheel, and the next record says so.
        wheel.state = wheel.history.state_at(*tick).value();
        heights.push_back(wheel.state.height_mm());
        wheel.tick(kTicks + again, TickRecord::kStatePut);  // a hand that is away
        ASSERT_EQ(wheel.history.state().hash(), wheel.state.hash());
        ASSERT_EQ(wheel.history.ticks(), *tick + 1);
    }
    ASSERT_EQ(heights.size(), 4U);
    EXPECT_EQ(wheel.history.moves().size(), 0U);
    // Rings that joined before the first touch round the height; the clay is the lump's.
    EXPECT_NEAR(heights.back(), test::studio_start().height_mm(), 1e-4) << "all is undone";
    EXPECT_EQ(wheel.state.studio()->ledger().trimmings_mm3, 0.0);
}

TEST_F(HistoryTest, GoesOnFromWhereItWasTakenBackTo) {
    wheel.throw_until(kTicks);
    wheel.state = wheel.history.state_at(2000).value();
    wheel.tick(2000, TickRecord::kStatePut);
    wheel.throw_until(kTicks);
    Wheel straight;
    straight.throw_until(kTicks);
    EXPECT_EQ(wheel.history.state().hash(), straight.history.state().hash());
    EXPECT_EQ(wheel.history.moves().size(), straight.history.moves().size());
    EXPECT_EQ(wheel.history.state_at(3000).value().hash(), straight.history.state_at(3000).value().hash());
}

TEST_F(HistoryTest, RestartsWithAFreshLump) {
    wheel.throw_until(1500);
    wheel.state.restart_from(test::studio_start());
    wheel.tick(0, TickRecord::kFreshLump);
    EXPECT_EQ(wheel.history.ticks(), 1U);
    EXPECT_EQ(wheel.history.state().hash(), wheel.state.hash());
    EXPECT_FALSE(wheel.history.before_last_move());
    EXPECT_EQ(wheel.history.checkpoint_count(), 1U);
}

TEST_F(HistoryTest, SaysSoWhenARecordIsMissing) {
    wheel.throw_until(100);
    haptic::tick(wheel.state, test::studio_hand(100, kHistoryRateHz),
                 wheel.parameters);  // not recorded
    wheel.throw_until(200);
    EXPECT_FALSE(wheel.history.is_whole());
    wheel.state.restart_from(test::studio_start());
    wheel.tick(0, TickRecord::kFreshLump);
    EXPECT_TRUE(wheel.history.is_whole());
}

TEST_F(HistoryTest, ThinsItsCheckpointsOutRatherThanGrowForEver) {
    Wheel few({.checkpoint_s = 0.1, .most_bytes = 200'000});
    few.throw_until(kTicks);
    EXPECT_LE(few.history.checkpoint_bytes(), 200'000U);
    EXPECT_LT(few.history.checkpoint_count(), 60U);
    EXPECT_GT(few.history.checkpoint_count(), 5U);
    Wheel all;
    all.throw_until(kTicks);
    EXPECT_EQ(few.history.state_at(1234).value().hash(), all.history.state_at(1234).value().hash());
}

TEST_F(HistoryTest, LetsGoOfStatesAndCanStillWorkThemOut) {
    wheel.throw_until(3000);
    const std::uint64_t before = wheel.history.state_at(1700).value().hash();
    wheel.history.let_go_of_states();
    EXPECT_EQ(wheel.history.checkpoint_count(), 2U) << "the start, and now";
    EXPECT_EQ(wheel.history.ticks_to_replay(1700), 1700U);
    EXPECT_EQ(wheel.history.state_at(1700).value().hash(), before);
    wheel.throw_until(kTicks);
    EXPECT_EQ(wheel.history.state_at(kTicks).value().hash(), wheel.state.hash());
    EXPECT_LT(wheel.history.ticks_to_replay(kTicks), 500U) << "what comes is kept as before";
}

TEST_F(HistoryTest, IsTheSameWhereItIsSpillFile) {
    const test::TemporaryFolder folder;
    HapticParameters parameters = parameters_at(kHistoryRateHz);
    History aside(test::studio_start(), parameters, {.aside = folder / "state"});
    History in_memory(test::studio_start(), parameters);
    for (std::uint64_t tick = 0; tick < 10'000; ++tick) {
        aside.add_played(test::studio_hand(tick, kHistoryRateHz));
        in_memory.add_played(test::studio_hand(tick, kHistoryRateHz));
    }
    for (const std::uint64_t tick : {0U, 4097U, 9'999U, 3U})
        EXPECT_EQ(aside.state_at(tick).value().hash(), in_memory.state_at(tick).value().hash()) << tick;
    ASSERT_TRUE(aside.save(folder / "aside"));
    ASSERT_TRUE(in_memory.save(folder / "in-memory"));
    EXPECT_EQ(test::content_of(folder / "aside"), test::content_of(folder / "in-memory"));
}

TEST_F(HistoryTest, IsSavedAsASessionThatReplays) {
    const test::TemporaryFolder folder;
    wheel.throw_until(kTicks);
    wheel.state = wheel.history.state_at(3100).value();
    wheel.tick(9000, TickRecord::kStatePut);
    wheel.throw_until(3456);
    ASSERT_TRUE(wheel.history.save(folder / "s.onggi"));
    auto session = record::parse_session(test::content_of(folder / "s.onggi"), "s.onggi");
    ASSERT_TRUE(session) << session.error().message;
    ASSERT_EQ(session->tick_count(), 3456U);
    auto start = start_from_bytes(session->start_state(), session->header().rate_hz);
    ASSERT_TRUE(start) << start.error().message;
    ASSERT_EQ(start->state.hash(), session->header().start_state_hash);
    record::SessionCursor cursor(*session);
    for (std::uint64_t tick = 0; tick < session->tick_count(); ++tick) {
        const auto result = haptic::tick(start->state, cursor.at(tick), start->parameters);
        ASSERT_TRUE(session->has_force_at(tick, result.forces.total_n())) << tick;
        if ((tick + 1) % record::kHashInterval == 0) {
            ASSERT_EQ(start->state.hash(), session->blocks()[tick / record::kHashInterval].state_hash);
        }
    }
    EXPECT_EQ(start->state.hash(), wheel.history.state().hash());
}

// A finger that lands and lifts, and a ball between two touches.
tool::ToolState landing_and_lifting(std::uint64_t tick) {
    tool::ToolState tool = test::studio_hand(tick, kHistoryRateHz);
    tool.guided = tick % 900 < 700;
    tool.pressing = tick % 150 < 110;
    return tool;
}

TEST_F(HistoryTest, KeepsWhenAFingerPressesAndWhenItLetsGo) {
    const test::TemporaryFolder folder;
    std::vector<std::uint64_t> hashes;
    while (wheel.state.ticks < kTicks) {
        if (wheel.state.ticks % 331 == 0) hashes.push_back(wheel.state.hash());
        wheel.tick(landing_and_lifting(wheel.state.ticks));
    }
    for (std::size_t i = 0; i < hashes.size(); ++i)
        ASSERT_EQ(wheel.history.state_at(331 * i).value().hash(), hashes[i]) << "tick " << 331 * i;
    ASSERT_TRUE(wheel.history.save(folder / "s.onggi"));
    const auto session = record::parse_session(test::content_of(folder / "s.onggi"), "s.onggi");
    ASSERT_TRUE(session) << session.error().message;
    record::SessionCursor cursor(*session);
    for (std::uint64_t tick = 0; tick < kTicks; ++tick)
        ASSERT_EQ(cursor.at(tick), landing_and_lifting(tick)) << tick;
    EXPECT_EQ(session->blocks().back().state_hash, wheel.state.hash());
}

TEST_F(HistoryTest, WritesASessionWhileItGoesOn) {
    const test::TemporaryFolder folder;
    auto writer = wheel.history.begin_session(folder / "growing.onggi", files::Beside::kNameless);
    ASSERT_TRUE(writer) << writer.error().message;
    const std::uint64_t lineage = wheel.history.lineage();
    for (const std::uint64_t until : {1U, 999U, 1000U, 2500U, 3456U}) {
        wheel.throw_until(until);
        while (writer->tick_count() < until)
            ASSERT_TRUE(wheel.history.write_on(*writer, 700));
    }
    EXPECT_EQ(wheel.history.lineage(), lineage);
    ASSERT_TRUE(writer->prepare(wheel.history.state().hash()));
    ASSERT_TRUE(writer->commit());
    ASSERT_TRUE(wheel.history.save(folder / "at-once.onggi"));
    EXPECT_EQ(test::content_of(folder / "growing.onggi"), test::content_of(folder / "at-once.onggi"));
}

TEST_F(HistoryTest, CountsEveryTimeItWentAnotherWay) {
    wheel.throw_until(1500);
    const std::uint64_t first = wheel.history.lineage();
    wheel.state = wheel.history.state_at(1200).value();
    wheel.tick(9000, TickRecord::kStatePut);
    EXPECT_EQ(wheel.history.lineage(), first + 1);
    wheel.state = test::studio_start();
    wheel.tick(0, TickRecord::kFreshLump);
    EXPECT_EQ(wheel.history.lineage(), first + 2);
}

TEST_F(HistoryTest, IsTheSameWhenItsToolsArePlayedBack) {
    const test::TemporaryFolder folder;
    wheel.throw_until(kTicks);
    ASSERT_TRUE(wheel.history.save(folder / "lived.onggi"));
    auto session = record::parse_session(test::content_of(folder / "lived.onggi"), "lived.onggi");
    ASSERT_TRUE(session);
    record::SessionCursor cursor(*session);
    History played(test::studio_start(), parameters_at(kHistoryRateHz));
    for (std::uint64_t tick = 0; tick < session->tick_count(); ++tick)
        played.add_played(cursor.at(tick));
    EXPECT_EQ(played.moves().size(), wheel.history.moves().size());
    ASSERT_TRUE(played.save(folder / "played.onggi"));
    EXPECT_EQ(test::content_of(folder / "played.onggi"), test::content_of(folder / "lived.onggi"));
}

#ifdef NDEBUG
// Five minutes at the kiosk's rate, with a pot of a tenth of the rings and so a tenth of the room for
// checkpoints. A visitor waits for the replayed ticks: with all the rings some 6 us each, and 25 us if every
// row is dented, so 3000 of them take 20 to 80 ms.
class FiveMinutes : public testing::Test {
  protected:
    static constexpr double kKioskRateHz = 4000.0;
    static constexpr auto kSession = static_cast<std::uint64_t>(300.0 * kKioskRateHz);

    // With a wheel that stands, every touched row stays dented: the checkpoints are ten times as large.
    static History session(bool wheel_turns) {
        clay::StudioClay wall({.mass_g = 2000.0, .rings = 200});
        wall.set_wall(45.0, 6.5, 12.0, 150.0, 150);
        HapticParameters parameters = parameters_at(kKioskRateHz);
        History history(HapticState(std::move(wall)), parameters,
                        {.most_bytes = HistoryOptions{}.most_bytes / 10});
        tool::ToolState tool;
        tool.wheel_button = wheel_turns;
        for (std::uint64_t tick = 0; tick < kSession; ++tick) {
            // Up the wall in 8 s, a millimetre and a half deep, then away for one.
            const double t_s = static_cast<double>(tick) / kKioskRateHz;
            const double fraction = std::fmod(t_s, 9.0) / 8.0;
            tool.position_mm = {fraction < 1.0 ? 53.5 : 120.0, 20.0 + 125.0 * std::min(fraction, 1.0), 0.0};
            history.add({.tick = static_cast<std::uint32_t>(tick), .tool = tool});
        }
        return history;
    }
    static std::uint64_t most_to_replay(const History& history) {
        std::uint64_t most = 0;
        for (std::uint64_t tick = 0; tick <= history.ticks(); ++tick)
            most = std::max(most, history.ticks_to_replay(tick));
        return most;
    }
};

TEST_F(FiveMinutes, AreTakenBackByReplayingASecondAtMost) {
    const History history = session(true);
    ASSERT_EQ(history.ticks(), kSession);
    EXPECT_GT(history.moves().size(), 20U);
    EXPECT_LE(most_to_replay(history), 3000U);
    EXPECT_EQ(history.state_at(*history.before_last_move()).value().ticks, *history.before_last_move());
}

TEST_F(FiveMinutes, OfDentsAreTakenBackByReplayingFewSeconds) {
    const History history = session(false);
    EXPECT_GT(history.state().studio()->residuals_mm(100).size(), 0U);
    EXPECT_LE(history.checkpoint_bytes(), HistoryOptions{}.most_bytes / 10);
    EXPECT_LE(most_to_replay(history), 6000U);
}
#endif

TEST_F(HistoryTest, KeepsCheckpointsCloserAtAHigherRate) {
    HapticParameters parameters = parameters_at(10'000.0);
    History history(test::studio_start(), parameters);
    for (std::uint64_t tick = 0; tick < 10'001; ++tick)
        history.add({.tick = static_cast<std::uint32_t>(tick), .tool = test::studio_hand(tick, 10'000.0)});
    EXPECT_EQ(history.ticks_to_replay(9'999), 999U);
    EXPECT_EQ(history.ticks_to_replay(2'999), 2'999U);
}

}  // namespace
}  // namespace onggi::haptic

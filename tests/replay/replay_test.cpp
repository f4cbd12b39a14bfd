#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "game/app/command_line/performance.h"
#include "game/app/command_line/throw_outputs.h"
#include "game/app/replay/replay.h"
#include "game/app/replay/session_marks.h"
#include "game/haptic/history.h"
#include "game/haptic/pot_copy.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

using test::TemporaryFolder;

std::string stored(const std::string& name) {
    return test::in_checkout("tests/replay/sessions/") + name;
}

LoadedSession loaded(const std::string& file) {
    auto session = load_session(file);
    if (!session) throw std::runtime_error(session.error().message);
    return std::move(session).value();
}

std::string words_for(const std::optional<Difference>& difference) {
    if (!difference) return "none";
    return std::to_string(difference->first_tick) + " to " + std::to_string(difference->last_tick) + ": " +
           difference->what;
}

constexpr std::array kSessions{"vase-100hz.onggi", "touch-still-300hz.onggi", "two-hands-250hz.onggi",
                               "one-finger-250hz.onggi"};

TEST(StoredSession, ReplaysToTheBitInThisBuild) {
    for (const char* name : kSessions) {
        LoadedSession session = loaded(stored(name));
        EXPECT_GT(session.session.tick_count(), 300U);
        EXPECT_TRUE(session.session.is_complete());
        EXPECT_EQ(words_for(find_difference(session.session, std::move(session.start))), "none") << name;
    }
}

// A stored session's pot, with a band of iron and a crane on it, kept at `place`.
decoration::Recorded decorate(const std::string& place) {
    LoadedSession session = loaded(stored("one-finger-250hz.onggi"));
    haptic::History history(session.start.state, session.start.parameters);
    record::SessionCursor cursor(session.session);
    for (std::uint64_t tick = 0; tick < session.session.tick_count(); ++tick)
        history.add_played(cursor.at(tick));
    using decoration::Stroke;
    decoration::Canvas canvas(wall_of(haptic::pot_of(history.state())));
    Stroke band{.technique = decoration::Technique::kIron};
    for (int i = 0; i <= 32; ++i)
        band.points.push_back(decoration::stroke_point(i / 32.0, 0.6 * canvas.wall().height_mm).value());
    EXPECT_TRUE(canvas.begin(band));
    EXPECT_TRUE(
        canvas.begin({.technique = decoration::Technique::kMotif,
                      .motif = decoration::Motif::kCrane,
                      .width = 2500,
                      .points = {decoration::stroke_point(0.75, 0.4 * canvas.wall().height_mm).value()}}));
    EXPECT_TRUE(history.save(place, decoration::bytes_of(canvas.recorded())));
    return canvas.recorded();
}

TEST(DecoratedSession, ReplaysToTheSameTexture) {
    const TemporaryFolder folder;
    const decoration::Recorded recorded = decorate(folder / "pot.onggi");
    LoadedSession session = loaded(folder / "pot.onggi");
    EXPECT_EQ(session.decoration, recorded);
    EXPECT_EQ(words_for(find_difference(session.session, std::move(session.start), session.decoration)),
              "none");
}

TEST(DecoratedSession, SaysThatItsStrokesComeToSomethingElse) {
    const TemporaryFolder folder;
    decorate(folder / "pot.onggi");
    LoadedSession session = loaded(folder / "pot.onggi");
    session.decoration.strokes.front().width = 900;
    const auto difference = find_difference(session.session, std::move(session.start), session.decoration);
    ASSERT_TRUE(difference);
    EXPECT_EQ(sentence_for(*difference),
              "every tick is as recorded, but its strokes give another texture than recorded");
}

TEST(DecoratedSession, IsRefusedWithInvalidStrokes) {
    const TemporaryFolder folder;
    LoadedSession session = loaded(stored("one-finger-250hz.onggi"));
    const haptic::History history(session.start.state, session.start.parameters);
    std::vector<std::byte> bytes = decoration::bytes_of({});
    bytes.resize(5);
    ASSERT_TRUE(history.save(folder / "pot.onggi", bytes));
    const auto refused = load_session(folder / "pot.onggi");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kBadInput);
    EXPECT_NE(refused.error().message.find("pot.onggi: decoration byte 0: expected a head, found the end"),
              std::string::npos);
}

// Throws the performance and keeps it as a session at `place`.
void record_session(Performance& performance, const std::string& place) {
    ThrowOutputs outputs;
    outputs.session = place;
    auto writer = OutputWriter::create(outputs, performance.start);
    ASSERT_TRUE(writer);
    haptic::HapticState& state = performance.start.state;
    const auto& parameters = performance.start.parameters;
    for (std::uint64_t tick = 0; tick < performance.tick_count; ++tick) {
        const auto tool = performance.player->read_tool(tick, parameters.dt_s());
        ASSERT_TRUE(writer->add_tick(state, haptic::tick(state, tool, parameters)));
    }
    ASSERT_TRUE(writer->finish(state, {}, {}));
}

// Sessions of whole tools were stored before their blocks were packed: they have the same content, in other
// bytes.
TEST(StoredSession, IsRecordedAgainToTheBit) {
    const TemporaryFolder folder;
    for (const char* name : kSessions) {
        auto performance = load_performance({.file = stored(name)});
        ASSERT_TRUE(performance) << performance.error().message;
        record_session(*performance, (folder / name).string());
        LoadedSession again = loaded(folder / name);
        const LoadedSession before = loaded(stored(name));
        if (before.session.header().tool_detail == record::ToolDetail::kPlain) {
            EXPECT_TRUE(test::content_of(folder / name) == test::content_of(stored(name))) << name;
        }
        EXPECT_EQ(again.session.header(), before.session.header());
        const auto state = again.session.start_state();
        const auto state_before = before.session.start_state();
        EXPECT_TRUE(std::equal(state.begin(), state.end(), state_before.begin(), state_before.end()));
        ASSERT_EQ(again.session.tick_count(), before.session.tick_count()) << name;
        record::SessionCursor cursor(again.session);
        record::SessionCursor cursor_before(before.session);
        for (std::uint64_t tick = 0; tick < again.session.tick_count(); ++tick)
            ASSERT_EQ(cursor.at(tick), cursor_before.at(tick)) << name << ", " << tick;
        EXPECT_EQ(again.session.blocks().back().state_hash, before.session.blocks().back().state_hash);
        EXPECT_EQ(words_for(find_difference(again.session, std::move(again.start))), "none");
    }
}

// A whole pot of the studio's clay by two hands, wet ones, with every tool there is. The hash is here and not
// only in the file, so that a silently replaced recording is noticed too.
TEST(StoredSession, OfTheStudioClayEndsInTheStateThatWasStored) {
    LoadedSession session = loaded(stored("two-hands-250hz.onggi"));
    haptic::Start& start = session.start;
    EXPECT_EQ(session.session.header().tool_detail, record::ToolDetail::kWhole);
    record::SessionCursor hands(session.session);
    bool second_touched = false;
    double wettest = 0.0;
    for (std::uint64_t tick = 0; tick < session.session.tick_count(); ++tick) {
        const tool::ToolState tool = hands.at(tick);
        const haptic::TickResult result = haptic::tick(start.state, tool, start.parameters);
        second_touched = second_touched || (tool.second.present && result.second_forces.contacts > 0);
        wettest = std::max(wettest, start.state.studio()->film());
    }
    const clay::StudioClay& clay = *start.state.studio();
    EXPECT_TRUE(second_touched);
    EXPECT_GT(wettest, 0.9);
    EXPECT_GT(clay.ledger().trimmings_mm3, 1000.0);
    EXPECT_GT(clay.ledger().slip_mm3, 0.0);
    EXPECT_TRUE(clay.is_cut_off());
    EXPECT_EQ(clay.ledger_error_mm3(), 0.0);
    EXPECT_EQ(fmt::format("{:016x}", start.state.hash()), "5a5f1a1514b98150");
}

// A finger that lands and lifts: the recording says when it touched the clay.
TEST(StoredSession, OfOneFingerLeavesTheClayAloneWhereItDoesNotPress) {
    LoadedSession session = loaded(stored("one-finger-250hz.onggi"));
    haptic::Start& start = session.start;
    record::SessionCursor hands(session.session);
    int landings = 0;
    std::uint64_t touching = 0;
    tool::ToolState before;
    before.pressing = false;
    for (std::uint64_t tick = 0; tick < session.session.tick_count(); ++tick) {
        const tool::ToolState tool = hands.at(tick);
        const haptic::TickResult result = haptic::tick(start.state, tool, start.parameters);
        if (tool.guided && tool.pressing && !before.pressing) ++landings;
        const bool touches = result.forces.contacts > 0 || result.grip.grip != clay::studio::Grip::kNone;
        if (touches) ++touching;
        if (!tool.pressing) {
            ASSERT_FALSE(touches) << tick;
            ASSERT_EQ(result.forces.total_n(), dvec3(0.0)) << tick;
        }
        before = tool;
    }
    EXPECT_EQ(landings, 7);
    EXPECT_GT(touching, 1000U);
    EXPECT_EQ(start.state.studio()->ledger_error_mm3(), 0.0);
}

// An undone move leaves no trace in a session; repeating it leads to the same state.
TEST(StoredSession, EndsTheSameWhenAMoveIsTakenBackAndDoneAgain) {
    LoadedSession session = loaded(stored("two-hands-250hz.onggi"));
    haptic::History history(session.start.state, session.start.parameters);
    record::SessionCursor hands(session.session);
    std::uint32_t flags = 0;
    std::uint64_t tick = 0;
    const auto follow_until = [&](std::uint64_t end) {
        for (; tick < end; ++tick)
            history.add({.tick = static_cast<std::uint32_t>(tick),
                         .flags = std::exchange(flags, 0U),
                         .tool = hands.at(tick)});
    };
    // In the middle of the pull, behind the sponge, and behind the last cut.
    for (const std::uint64_t moment :
         {std::uint64_t{1650}, std::uint64_t{3280}, session.session.tick_count()}) {
        follow_until(moment);
        tick = history.before_last_move().value();
        EXPECT_LT(tick, moment);
        flags = haptic::TickRecord::kStatePut;
    }
    follow_until(session.session.tick_count());
    ASSERT_TRUE(history.is_whole());
    EXPECT_EQ(history.state().hash(), session.session.blocks().back().state_hash);
}

// Kernels of other widths have to give the same bits.
TEST(StoredSession, ReplaysWithEveryKernelThisMachineHas) {
    for (const clay::KernelVariant variant : {clay::KernelVariant::kPlain, clay::KernelVariant::kWide}) {
        if (!clay::is_supported(variant)) continue;
        LoadedSession session = loaded(stored("vase-100hz.onggi"));
        session.start.state.paper()->use_kernel(variant);
        EXPECT_EQ(words_for(find_difference(session.session, std::move(session.start))), "none");
    }
}

TEST(Replay, NoticesAnotherStart) {
    LoadedSession session = loaded(stored("vase-100hz.onggi"));
    const float radius = 60.01F;
    session.start.state.paper()->set_radii_mm(std::span(&radius, 1), 42);
    EXPECT_EQ(words_for(find_difference(session.session, std::move(session.start))),
              "0 to 0: the start state is not the one that was recorded");
}

// If the clay model has changed since the recording, the first tick with another force is reported.
TEST(Replay, NamesTheFirstTickThatADifferentClayFeels) {
    LoadedSession session = loaded(stored("vase-100hz.onggi"));
    // Where the recorded hand first touches.
    haptic::Start start = session.start;
    record::SessionCursor cursor(session.session);
    std::uint64_t touch = 0;
    while (haptic::tick(start.state, cursor.at(touch), start.parameters).forces.contacts == 0)
        ++touch;
    ASSERT_GT(touch, 10U);

    session.start.parameters.paper.stiffness_turning_n_per_mm *= 1.0 + 1e-12;
    EXPECT_EQ(words_for(find_difference(session.session, std::move(session.start))),
              std::to_string(touch) + " to " + std::to_string(touch) +
                  ": its force is not the one that was recorded");
}

TEST(Replay, NarrowsAStateThatIsNotFeltToItsBlock) {
    // Without friction no force depends on the wheel's speed: only the state's hash shows its angle.
    const TemporaryFolder folder;
    auto performance = load_performance({.file = stored("vase-100hz.onggi")});
    ASSERT_TRUE(performance);
    performance->start.parameters.paper.friction_c3_n_s_per_mm = 0.0;
    record_session(*performance, (folder / "s.onggi").string());

    LoadedSession session = loaded((folder / "s.onggi").string());
    session.start.parameters.paper.wheel_speed_rad_s = 3.0;
    EXPECT_EQ(words_for(find_difference(session.session, std::move(session.start))),
              "0 to 999: every force is as recorded, but the state after them is not");
}

TEST(Replay, TellsOfEveryTick) {
    LoadedSession session = loaded(stored("touch-still-300hz.onggi"));
    std::uint64_t told = 0;
    EXPECT_FALSE(find_difference(session.session, std::move(session.start), {},
                                 [&](std::uint64_t tick) { EXPECT_EQ(tick, told++); }));
    EXPECT_EQ(told, session.session.tick_count());
}

}  // namespace
}  // namespace onggi::app

#include <gtest/gtest.h>

#include <stdexcept>

#include "game/app/performance.h"
#include "game/app/replay_command.h"
#include "game/app/throw_outputs.h"
#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

using test::TemporaryFolder;

std::string stored(const std::string& name) {
    return ONGGI_SOURCE_DIR "/tests/replay/sessions/" + name;
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

TEST(StoredSession, ReplaysToTheBitInThisBuild) {
    for (const char* name : {"vase-100hz.onggi", "touch-still-300hz.onggi"}) {
        LoadedSession session = loaded(stored(name));
        EXPECT_GT(session.session.tick_count(), 300U);
        EXPECT_TRUE(session.session.is_complete());
        EXPECT_EQ(words_for(find_difference(session.session, std::move(session.start))), "none") << name;
    }
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
        const auto tool = performance.hand->read(tick, parameters.dt_s());
        ASSERT_TRUE(writer->add_tick(state, haptic::tick(state, tool, parameters)));
    }
    ASSERT_TRUE(writer->finish(state, {}, {}));
}

TEST(StoredSession, IsRecordedAgainToTheByte) {
    const TemporaryFolder folder;
    for (const char* name : {"vase-100hz.onggi", "touch-still-300hz.onggi"}) {
        auto performance = load_performance({.file = stored(name)});
        ASSERT_TRUE(performance) << performance.error().message;
        record_session(*performance, (folder / name).string());
        EXPECT_TRUE(test::content_of(folder / name) == test::content_of(stored(name))) << name;
    }
}

// Kernels of other widths have to give the same bits.
TEST(StoredSession, ReplaysWithEveryKernelThisMachineHas) {
    for (const clay::KernelVariant variant :
         {clay::KernelVariant::kPlain, clay::KernelVariant::kSse, clay::KernelVariant::kAvx2}) {
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

// What a clay that has changed since the recording comes to: noticed at the first tick that is felt.
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
    // Without friction nobody feels how fast the wheel turns: only the state's hash knows where it stands.
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
    EXPECT_FALSE(find_difference(session.session, std::move(session.start),
                                 [&](std::uint64_t tick) { EXPECT_EQ(tick, told++); }));
    EXPECT_EQ(told, session.session.tick_count());
}

}  // namespace
}  // namespace onggi::app

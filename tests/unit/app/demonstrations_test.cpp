// Demonstrations: the choice of recordings, missing ones, and that the kiosk's loop reproduces the recorded
// pots.
#include "game/app/kiosk/presentation/demonstrations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <utility>

#include "game/haptic/job.h"
#include "game/haptic/start_state.h"
#include "game/record/session_writer.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;

const fs::path kRecordings = test::in_checkout("assets/demonstrations");
const fs::path kGesture = test::in_checkout("assets/gestures/attract.csv");

haptic::HapticState lump() {
    return haptic::HapticState(clay::StudioClay(clay::StudioLump{}));
}

void list(const fs::path& folder, const std::string& names) {
    std::ofstream(folder / "shown.txt") << names;
}

std::vector<std::string> names_of(const Show& show) {
    std::vector<std::string> names;
    for (const Recording& recording : show.recordings)
        names.push_back(recording.name);
    return names;
}

TEST(Show, IsTheRecordingsOfTheListInItsOrder) {
    std::vector<std::string> remarks;
    std::vector<std::string> pots{"cylinder", "vase", "bowl", "moon_jar_half", "moon_jar"};
    const Show show = load_show(kRecordings, kGesture, {lump()}, remarks);
    EXPECT_EQ(names_of(show), pots);
    EXPECT_FALSE(show.gesture);
    pots.emplace_back("collapse");
    EXPECT_EQ(names_of(load_show(kRecordings, kGesture, {lump(), false}, remarks)), pots);
    EXPECT_TRUE(remarks.empty()) << remarks.front();
}

TEST(Show, SaysWhichLineOfTheListItDoesNotUnderstand) {
    const test::TemporaryFolder folder;
    fs::copy_file(kRecordings / "bowl.onggi", folder / "bowl.onggi");
    list(folder.path(), "bowl\nbowl forgiving\n\n");
    std::vector<std::string> remarks;
    EXPECT_EQ(names_of(load_show(folder.path(), kGesture, {lump()}, remarks)),
              std::vector<std::string>{"bowl"});
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_NE(remarks[0].find("shown.txt, line 2: expected a name, or a name and 'unforgiving', found "
                              "'bowl forgiving'"),
              std::string::npos)
        << remarks[0];
}

TEST(Show, GoesOnWithTheNextWhereOneIsMissingOrDamagedOrOfOtherClay) {
    const test::TemporaryFolder folder;
    fs::copy_file(kRecordings / "bowl.onggi", folder / "bowl.onggi");
    std::string damaged = test::content_of(kRecordings / "vase.onggi");
    damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 1);
    std::ofstream(folder / "damaged.onggi", std::ios::binary) << damaged;
    list(folder.path(), "none\ndamaged\nbowl\n");
    std::vector<std::string> remarks;
    EXPECT_EQ(names_of(load_show(folder.path(), kGesture, {lump()}, remarks)),
              std::vector<std::string>{"bowl"});
    ASSERT_EQ(remarks.size(), 2U);
    EXPECT_NE(remarks[0].find("none.onggi"), std::string::npos);
    EXPECT_NE(remarks[1].find("damaged.onggi: "), std::string::npos);

    remarks.clear();
    const haptic::HapticState coarse(clay::StudioClay({.rings = 1000}));
    const Show gesture = load_show(folder.path(), kGesture, {coarse}, remarks);
    EXPECT_TRUE(gesture.recordings.empty());
    ASSERT_EQ(remarks.size(), 4U);
    EXPECT_NE(remarks[2].find("bowl.onggi: expected studio clay of 1000 rings"), std::string::npos)
        << remarks[2];
}

TEST(Show, PlaysTheGestureWithoutRecordingsAndIsEmptyWithoutBoth) {
    const test::TemporaryFolder folder;
    list(folder.path(), "");
    std::vector<std::string> remarks;
    EXPECT_TRUE(load_show(folder.path(), kGesture, {lump()}, remarks).gesture);
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_NE(remarks[0].find("expected a recorded session to show, found none"), std::string::npos);
    const Show nothing = load_show(folder / "none", folder / "none.csv", {lump()}, remarks);
    EXPECT_TRUE(nothing.recordings.empty());
    EXPECT_FALSE(nothing.gesture);
    EXPECT_EQ(remarks.size(), 4U);
}

// Played at ten times the recorded rate, a pressing finger is interpolated, but not between lifting and
// landing.
TEST(DemonstrationDevice, IsWhereItLiftsAndWhereItLandsAndNotBetween) {
    const test::TemporaryFolder folder;
    haptic::Start start{lump(), {}};
    start.parameters.set_rate_hz(100.0);
    auto writer = record::SessionWriter::create(folder / "taps.onggi", haptic::session_header(start),
                                                haptic::start_state_bytes(start.state, start.parameters));
    ASSERT_TRUE(writer) << writer.error().message;
    const auto finger = [&](double x_mm, bool pressing) {
        return writer->add_tick({.position_mm = {x_mm, 20.0, 0.0}, .guided = true, .pressing = pressing},
                                dvec3(0.0));
    };
    for (const auto& [x_mm, pressing] : {std::pair{60.0, true}, {50.0, true}, {-60.0, false}, {40.0, true}})
        ASSERT_TRUE(finger(x_mm, pressing));
    ASSERT_TRUE(writer->prepare(0));
    ASSERT_TRUE(writer->commit());
    list(folder.path(), "taps\n");
    std::vector<std::string> remarks;
    const Show show = load_show(folder.path(), kGesture, {lump()}, remarks);
    ASSERT_EQ(names_of(show), std::vector<std::string>{"taps"});

    DemonstrationDevice hand(std::make_unique<haptic::SimulatedDevice>(), show.recordings, 1000.0);
    const auto at = [&](std::uint64_t tick) { return hand.read_tool(kShownTicks + tick, 0.001); };
    EXPECT_NEAR(at(5).position_mm.x, 55.0, 1e-9);
    EXPECT_EQ(at(19).position_mm.x, 50.0);
    EXPECT_TRUE(at(19).pressing);
    EXPECT_EQ(at(20).position_mm.x, -60.0);
    EXPECT_EQ(at(29).position_mm.x, -60.0);
    EXPECT_FALSE(at(29).pressing);
    EXPECT_EQ(at(30).position_mm.x, 40.0);
    EXPECT_TRUE(at(30).pressing);
    EXPECT_TRUE(at(30).guided);
}

// The kiosk's loop, on a clock of its own.
class Wheel : public testing::Test {
  protected:
    static constexpr double kRateHz = 1000.0;

    void load(const std::string& name, bool forgiving = true) {
        auto loaded = load_show(kRecordings, kGesture, {lump(), forgiving}, remarks_);
        for (Recording& recording : loaded.recordings)
            if (recording.name == name) show_.recordings.push_back(std::move(recording));
        ASSERT_EQ(show_.recordings.size(), 1U);
        auto person = std::make_unique<haptic::SimulatedDevice>();
        person_ = person.get();
        person_->set_target({.position_mm = kAway});
        haptic::HapticParameters parameters;
        parameters.set_rate_hz(kRateHz);
        parameters.studio.forgiving = forgiving;
        work_ = std::make_unique<haptic::HapticWork>(
            lump(), parameters,
            std::make_unique<DemonstrationDevice>(std::move(person), show_.recordings, kRateHz),
            haptic::HapticJobOptions{});
    }
    void tick(std::uint64_t ticks) {
        haptic::TickRecord record;
        for (std::uint64_t k = 0; k < ticks; ++k) {
            ASSERT_TRUE(work_->tick(period_));
            ++period_.index;
            ++period_.tick;
            while (work_->take_record(record)) {
            }
        }
    }

    static constexpr dvec3 kAway{250.0, 300.0, 0.0};
    std::vector<std::string> remarks_;
    Show show_;
    haptic::SimulatedDevice* person_ = nullptr;
    std::unique_ptr<haptic::HapticWork> work_;
    jobs::Period period_{.dt_s = 1.0 / kRateHz};
};

TEST_F(Wheel, MakesThePotOfTheRecordingAndKnowsWhenItIsOver) {
    load("moon_jar");
    tick(100);
    const Recording& jar = show_.recordings.front();
    ASSERT_TRUE(work_->put(first_state_of(jar, 0), 0));
    const auto ticks = static_cast<std::uint64_t>(jar.seconds() * kRateHz);
    tick(ticks);
    const haptic::Snapshot& end = work_->newest_snapshot();
    EXPECT_NEAR(played_s(end.tick, 0, kRateHz).value_or(0.0), jar.seconds(), 0.01);
    EXPECT_FALSE(played_s(end.tick, 1, kRateHz));
    // The height at the recorded rate is 171.2 mm, by the sessions' own test.
    EXPECT_NEAR(work_->state().height_mm(), 171.2, 0.3);
    EXPECT_EQ(end.body, clay::ClayBody::kPorcelain);
    EXPECT_EQ(end.fault, haptics::Fault::kNone);
}

TEST_F(Wheel, ShowsHowAPotGivesWayWhereAVisitorsWould) {
    load("collapse", false);
    ASSERT_TRUE(work_->put(first_state_of(show_.recordings.front(), 0), 0));
    tick(static_cast<std::uint64_t>(show_.recordings.front().seconds() * kRateHz));
    EXPECT_EQ(work_->newest_snapshot().load.failure.cause, clay::studio::Cause::kSpin);
    const auto outer = work_->state().studio()->outer_mm();
    EXPECT_NEAR(*std::max_element(outer.begin(), outer.end()), 150.0, 0.5) << "as wide as the wheel head";
}

TEST_F(Wheel, IsTheVisitorsAgainWithTheNextLump) {
    load("bowl");
    ASSERT_TRUE(work_->put(first_state_of(show_.recordings.front(), 0), 0));
    tick(4000);
    EXPECT_GT(glm::length(work_->state().tool.position_mm - kAway), 50.0) << "the recorded hand works";
    ASSERT_TRUE(work_->send(haptic::Command::kFreshLump));
    tick(1);
    EXPECT_EQ(work_->state().tool.position_mm, kAway) << "not through the clay from where it was";
    EXPECT_FALSE(played_s(work_->newest_snapshot().tick, 0, kRateHz));
    person_->set_target({.position_mm = {200.0, 300.0, 0.0}});
    tick(500);
    EXPECT_NEAR(work_->state().tool.position_mm.x, 200.0, 1.0);
}

}  // namespace
}  // namespace onggi::app

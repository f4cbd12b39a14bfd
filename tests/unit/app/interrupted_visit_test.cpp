// An interrupted visit: its journal on a real disk, recovery after damage, and its continuation.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/core/list_folder.h"
#include "game/app/kiosk/gallery/interrupted_session.h"
#include "game/app/kiosk/gallery/visit_journal.h"
#include "game/app/kiosk/keeping/kiosk_keeper.h"
#include "game/record/session.h"
#include "tests/support/comes_true.h"
#include "tests/support/hostile_system.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/haptic/studio_hand.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;

constexpr double kRateHz = 500.0;

haptic::HapticParameters parameters_at(double rate_hz) {
    haptic::HapticParameters parameters;
    parameters.set_rate_hz(rate_hz);
    return parameters;
}

// A wheel that is thrown on in simulated time, its history, and a journal that follows.
struct Visit {
    explicit Visit(const fs::path& folder) : journal(folder) {}

    void throw_until(std::uint64_t end) {
        while (state.ticks < end)
            tick(0);
        follow();
    }
    void tick(std::uint32_t flags) {
        const tool::ToolState tool = test::studio_hand(state.ticks, kRateHz);
        const haptic::TickResult result = haptic::tick(state, tool, parameters);
        history.add({.tick = static_cast<std::uint32_t>(state.ticks - 1),
                     .flags = flags,
                     .tool = state.tool,
                     .force_n = result.forces.total_n()});
    }
    void follow() {
        now_ns += 2'000'000'000;
        const auto written = journal.follow(history, now_ns);
        EXPECT_TRUE(written) << written.error().message;
    }

    haptic::HapticState state = test::studio_start();
    haptic::HapticParameters parameters = parameters_at(kRateHz);
    haptic::History history{state, parameters};
    VisitJournal journal;
    std::int64_t now_ns = 0;
};

struct Recovered {
    std::unique_ptr<InterruptedSession> pot;
    std::vector<std::string> remarks;
};

Recovered recover(const fs::path& folder, double rate_hz = kRateHz) {
    Recovered found;
    found.pot = InterruptedSession::find(folder, test::studio_start(), parameters_at(rate_hz), found.remarks);
    while (found.pot) {
        const auto more = found.pot->work(700);
        EXPECT_TRUE(more) << more.error().message;
        if (!more || !*more) break;
    }
    return found;
}

class InterruptedVisit : public testing::Test {
  protected:
    // Recovers from a copy of the journal, as after a kill, while the journal goes on.
    Recovered recover_after_a_kill(const fs::path& copy) {
        fs::copy(state_, copy, fs::copy_options::recursive);
        return recover(copy);
    }

    const test::TemporaryFolder folder_;
    const fs::path state_ = folder_ / "state";
    Visit visit_{state_};
};

TEST_F(InterruptedVisit, LosesNoMoreThanABlock) {
    visit_.throw_until(2345);
    const Recovered found = recover_after_a_kill(folder_ / "after");
    ASSERT_TRUE(found.pot);
    EXPECT_TRUE(found.remarks.empty());
    EXPECT_TRUE(found.pot->is_worth_it());
    EXPECT_EQ(found.pot->history().ticks(), 2000U);
    EXPECT_EQ(found.pot->history().state().hash(), visit_.history.state_at(2000).value().hash())
        << "to the bit";
}

TEST_F(InterruptedVisit, IsAsItWasAfterAnUndo) {
    visit_.throw_until(3100);
    visit_.state = visit_.history.state_at(1500).value();
    visit_.tick(haptic::TickRecord::kStatePut);
    visit_.follow();
    visit_.throw_until(2400);
    const Recovered found = recover_after_a_kill(folder_ / "after");
    ASSERT_TRUE(found.pot);
    EXPECT_EQ(found.pot->history().ticks(), 2000U);
    EXPECT_EQ(found.pot->history().state().hash(), visit_.history.state_at(2000).value().hash());
}

TEST_F(InterruptedVisit, IsGoneWhenItsLumpIsThrownAway) {
    visit_.throw_until(3100);
    visit_.state = test::studio_start();
    visit_.tick(haptic::TickRecord::kFreshLump);
    visit_.follow();
    EXPECT_FALSE(recover_after_a_kill(folder_ / "after").pot) << "the pot before was not wanted";
    visit_.throw_until(1400);
    const Recovered found = recover_after_a_kill(folder_ / "later");
    ASSERT_TRUE(found.pot);
    EXPECT_EQ(found.pot->history().ticks(), 1000U);
}

TEST_F(InterruptedVisit, LeavesNoFileWhenItIsOver) {
    visit_.throw_until(3100);
    EXPECT_FALSE(fs::is_empty(state_));
    visit_.journal.drop();
    EXPECT_TRUE(fs::is_empty(state_));
}

TEST_F(InterruptedVisit, StaysWhenTheProgramIsAskedToEnd) {
    visit_.throw_until(3100);
    ASSERT_TRUE(visit_.journal.leave());
    const Recovered found = recover(state_);
    ASSERT_TRUE(found.pot);
    EXPECT_EQ(found.pot->history().ticks(), 3000U);
}

TEST_F(InterruptedVisit, ResumesUpToItsLastIntactBlock) {
    visit_.throw_until(3100);
    const fs::path journal = folder_ / "state/visit-2.onggi.part";
    const std::string whole = test::content_of(journal);
    constexpr std::size_t kHeadBytes = 40;
    std::vector<std::size_t> bodies;
    for (std::size_t at = whole.find("TCKP"); at != std::string::npos; at = whole.find("TCKP", at + 1))
        bodies.push_back(at + kHeadBytes);
    ASSERT_EQ(bodies.size(), 3U);
    for (std::size_t block = 0; block < 3; ++block) {
        std::string bytes = whole;
        bytes[bodies[block] + 30] ^= 1;  // as a bad sector would
        test::put_file(journal, bytes);
        const Recovered found = recover_after_a_kill(folder_ / "after");
        ASSERT_EQ(found.remarks.size(), 1U);
        EXPECT_NE(found.remarks[0].find("then damaged: "), std::string::npos) << found.remarks[0];
        EXPECT_EQ(found.pot != nullptr, block > 0);
        if (found.pot) {
            EXPECT_EQ(found.pot->history().ticks(), 1000 * block);
        }
        fs::remove_all(folder_ / "after");
    }
    // A power cut leaves blocks of zeros.
    test::put_file(journal, whole.substr(0, bodies[1]) + std::string(5000, '\0'));
    EXPECT_EQ(recover(state_).pot->history().ticks(), 1000U);
}

TEST_F(InterruptedVisit, IsDroppedWithALineIfNoBlockIsIntact) {
    constexpr std::size_t kMuch = std::size_t{1} << 20U;
    for (const std::string& bytes : {"not a session" + std::string(kMuch, ' '), std::string(kMuch, '\0')}) {
        fs::create_directories(state_);
        test::put_file(folder_ / "state/visit-1.onggi.part", bytes);
        const Recovered found = recover(state_);
        EXPECT_FALSE(found.pot);
        ASSERT_EQ(found.remarks.size(), 1U);
        const std::string kept = (state_ / "dropped.onggi").string();
        EXPECT_TRUE(found.remarks[0].starts_with("interrupted visit: dropped, kept as " + kept + ": "))
            << found.remarks[0];
        EXPECT_EQ(found.remarks[0].find('\n'), std::string::npos);
        EXPECT_EQ(test::content_of(kept), bytes);
        EXPECT_EQ(list_folder(state_).entries.size(), 1U) << "in place of an earlier one";
        EXPECT_TRUE(recover(state_).remarks.empty()) << "and it is not met a second time";
    }
}

TEST_F(InterruptedVisit, IsFoundUnharmedIfTheDiskFailsWhileListingItsFolder) {
    visit_.throw_until(2345);
    const std::string journal = test::content_of(folder_ / "state/visit-2.onggi.part");
    fs::create_directories(folder_ / "after");
    for (int i = 1; i <= 30; ++i)
        test::put_file(folder_ / "after" / fmt::format("visit-{:02}.onggi", i), journal);
    const std::string told = test::in_child([&]() -> std::string {
        if (!test::fail_listings_after(2)) return "no such kernel";
        std::vector<std::string> remarks;
        const auto pot = InterruptedSession::find(folder_ / "after", test::studio_start(),
                                                  parameters_at(kRateHz), remarks);
        return fmt::format("{}; {}", pot ? "found" : "lost", fmt::join(remarks, "; "));
    });
    EXPECT_EQ(told, fmt::format("found; interrupted visit: {}: expected to list all that is in this folder, "
                                "found: Input/output error",
                                (folder_ / "after").string()));
    const FolderListing left = list_folder(folder_ / "after");
    EXPECT_EQ(left.entries.size(), 30U) << "what the disk did not tell of may be the longest";
    EXPECT_TRUE(fs::exists(folder_ / "after/left-over.onggi"));
}

TEST_F(InterruptedVisit, DoesNotExistBeforeItsFirstBlock) {
    for (const std::size_t size : {std::size_t{0}, std::size_t{72}}) {
        fs::create_directories(state_);
        test::put_file(folder_ / "state/visit-1.onggi.part", std::string(size, '\0'));
        const Recovered found = recover(state_);
        EXPECT_FALSE(found.pot);
        EXPECT_TRUE(found.remarks.empty()) << "nothing was lost";
        EXPECT_TRUE(fs::is_empty(state_));
    }
}

TEST_F(InterruptedVisit, IsDroppedWhereTheWheelIsAnother) {
    visit_.throw_until(2100);
    const Recovered found = recover(state_, 2.0 * kRateHz);
    EXPECT_FALSE(found.pot);
    ASSERT_EQ(found.remarks.size(), 1U);
    EXPECT_NE(found.remarks[0].find("expected this kiosk's rate of 1000 Hz, found 500 Hz"), std::string::npos)
        << found.remarks[0];
    EXPECT_FALSE(fs::exists(state_ / "left-over.onggi"));
    EXPECT_TRUE(fs::exists(state_ / "dropped.onggi"));
}

TEST_F(InterruptedVisit, IsDroppedWhereTheClayIsAnother) {
    visit_.throw_until(2100);
    haptic::HapticState other = test::studio_start();
    ++other.ticks;
    std::vector<std::string> remarks;
    EXPECT_FALSE(InterruptedSession::find(state_, other, parameters_at(kRateHz), remarks));
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_NE(remarks[0].find("expected this kiosk's lump and parameters, found others: "), std::string::npos)
        << remarks[0];
    EXPECT_TRUE(fs::exists(state_ / "dropped.onggi"));
}

TEST_F(InterruptedVisit, OfALaterProgramStaysForIt) {
    visit_.throw_until(2100);
    const fs::path journal = folder_ / "state/visit-2.onggi.part";
    std::string bytes = test::content_of(journal);
    ++bytes[record::kMagic.size()];  // the major version follows
    test::put_file(journal, bytes);
    const Recovered found = recover(state_);
    EXPECT_FALSE(found.pot);
    ASSERT_EQ(found.remarks.size(), 1U);
    EXPECT_NE(found.remarks[0].find("version"), std::string::npos) << found.remarks[0];
    EXPECT_EQ(test::content_of(state_ / "dropped.onggi"), bytes);
}

TEST_F(InterruptedVisit, GivesUpWithOneLineIfTheFolderIsNotWritable) {
    test::put_file(state_, "a file where a folder is wanted");
    visit_.tick(0);
    const auto written = visit_.journal.follow(visit_.history, 0);
    ASSERT_FALSE(written);
    EXPECT_TRUE(written.error().message.starts_with("journal: ")) << written.error().message;
    EXPECT_TRUE(visit_.journal.follow(visit_.history, 1)) << "said once";
}

TEST(VisitPlaces, AreFoundAgain) {
    const test::TemporaryFolder folder;
    const fs::path state = folder / "state";
    EXPECT_EQ(read_place(state).value(), VisitPlace{}) << "nothing was chosen";
    const VisitPlace place{.target = "moon-jar-nmk", .glaze = 4, .is_cut_off = true};
    ASSERT_TRUE(write_place(state, place));
    EXPECT_EQ(read_place(state).value(), place);
    remove_place(state);
    EXPECT_EQ(read_place(state).value(), VisitPlace{});
}

TEST(VisitPlaces, RejectsAnythingElseInOneLine) {
    const test::TemporaryFolder folder;
    for (const char* text : {"", "{}", "[1]", R"({"format": 2})", R"({"format": 1, "target": 3})",
                             R"({"format": 1, "target": "x", "glaze": 1e99, "is_cut_off": true})",
                             R"({"format": 1, "target": "x", "glaze": 1, "is_cut_off": "yes"})"}) {
        test::put_file(folder / "place.json", text);
        const auto read = read_place(folder.path());
        ASSERT_FALSE(read) << text;
        EXPECT_EQ(read.error().kind, ErrorKind::kBadInput);
        EXPECT_EQ(read.error().message.find('\n'), std::string::npos) << read.error().message;
        EXPECT_NE(read.error().message.find("place.json: expected the choices of a visit"),
                  std::string::npos);
    }
}

// The loop, the keeper and the disk as they are in a kiosk, on the real clock.
struct VisitedWheel {
    explicit VisitedWheel(const fs::path& gallery)
        : job(start, parameters, std::make_unique<test::StudioHand>(1000.0), {}) {
        kiosk::Config config;
        config.gallery.folder = gallery.string();
        config.gallery.least_free_mb = 1.0;
        keeper =
            std::make_unique<KioskKeeper>(job, start, parameters, Gallery(config), gallery / "statistics");
        EXPECT_TRUE(job.start());
        EXPECT_TRUE(keeper->start());
    }
    ~VisitedWheel() {
        keeper->stop();
        job.stop();
    }
    template <typename Condition>
    bool waits_for(Condition&& condition) {
        return test::comes_true([&] {
            while (const auto answer = keeper->next_answer()) {
                is_interrupted_session =
                    is_interrupted_session || std::holds_alternative<KeeperAnswer::Interrupted>(answer->what);
                words += answer->words + "\n";
            }
            return condition();
        });
    }
    [[nodiscard]] std::uint64_t tick() { return job.newest_snapshot().tick; }

    haptic::HapticState start = test::studio_start();
    haptic::HapticParameters parameters = parameters_at(1000.0);
    haptic::HapticJob job;
    std::unique_ptr<KioskKeeper> keeper;
    bool is_interrupted_session = false;
    std::string words;
};

TEST(InterruptedWheel, GoesOnOnTheWheelAndCanBeInterruptedAgain) {
    const test::TemporaryFolder gallery;
    {
        VisitedWheel wheel(gallery.path());
        ASSERT_TRUE(wheel.job.send(haptic::Command::kFreshLump));
        wheel.keeper->journal(1);
        ASSERT_TRUE(
            wheel.waits_for([&] { return wheel.job.newest_snapshot().run == 1 && wheel.tick() > 2600; }));
    }
    std::uint64_t first = 0;
    {
        VisitedWheel wheel(gallery.path());
        ASSERT_TRUE(wheel.waits_for([&] { return wheel.is_interrupted_session; })) << wheel.words;
        EXPECT_TRUE(fs::exists(gallery / "state/left-over.onggi"));
        wheel.keeper->resume(0);
        ASSERT_TRUE(wheel.waits_for([&] { return wheel.job.newest_snapshot().states_put == 1; }));
        first = wheel.tick();
        EXPECT_GE(first, 2000U);
        ASSERT_TRUE(wheel.waits_for([&] { return !fs::exists(gallery / "state/left-over.onggi"); }))
            << "it is in its new journal";
        ASSERT_TRUE(wheel.waits_for([&] { return wheel.tick() > first + 1200; }));
        // Undoes beyond the previous run.
        wheel.keeper->undo();
        ASSERT_TRUE(wheel.waits_for([&] { return wheel.job.newest_snapshot().states_put == 2; }))
            << wheel.words;
        ASSERT_TRUE(wheel.waits_for([&] { return wheel.tick() > first + 1200; }));
    }
    VisitedWheel wheel(gallery.path());
    ASSERT_TRUE(wheel.waits_for([&] { return wheel.is_interrupted_session; })) << wheel.words;
    wheel.keeper->resume(0);
    ASSERT_TRUE(wheel.waits_for([&] { return wheel.job.newest_snapshot().states_put == 1; }));
    EXPECT_GE(wheel.tick(), first);
    wheel.keeper->forget();
    EXPECT_TRUE(wheel.waits_for([&] { return fs::is_empty(gallery / "state"); })) << "the visitor has left";
}

TEST(InterruptedWheel, DoesNotExistAfterTheVisitorHasLeft) {
    const test::TemporaryFolder gallery;
    {
        VisitedWheel wheel(gallery.path());
        ASSERT_TRUE(wheel.job.send(haptic::Command::kFreshLump));
        wheel.keeper->journal(1);
        ASSERT_TRUE(
            wheel.waits_for([&] { return wheel.job.newest_snapshot().run == 1 && wheel.tick() > 2600; }));
        wheel.keeper->forget();
        ASSERT_TRUE(wheel.waits_for([&] { return fs::is_empty(gallery / "state"); }));
    }
    VisitedWheel wheel(gallery.path());
    EXPECT_TRUE(wheel.waits_for([&] { return wheel.tick() > 500; }));
    EXPECT_FALSE(wheel.is_interrupted_session);
}

}  // namespace
}  // namespace onggi::app

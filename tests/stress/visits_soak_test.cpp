// One scripted visitor after another. Memory, handles, threads and disk use stay constant, and every pot to
// be kept is kept. A few visitors in ./check; ONGGI_VISITS=200 for the long run, ONGGI_HOURS=24 for a day of
// them by the clock of the visits, ONGGI_MINUTES=60 for an hour by the clock on the wall.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>

#include "game/app/kiosk/gallery/kiosk_gallery.h"
#include "game/app/kiosk/health/kiosk_statistics.h"
#include "tests/stress/flat_figures.h"
#include "tests/stress/unseen_kiosk.h"
#include "tests/support/temporary_folder.h"
#include "tests/visitors/judge.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;
using kiosk::Button;
using kiosk::Screen;

// A number from the environment, or the default.
int wanted(const char* name, int usual) {
    const char* words = std::getenv(name);
    return words != nullptr ? std::atoi(words) : usual;
}

// One visit from attract to attract. Returns whether a pot was to be kept.
bool visit(UnseenKiosk& kiosk, std::mt19937& chance) {
    const auto on = [&](Screen screen) { return [&kiosk, screen] { return kiosk.screen() == screen; }; };
    kiosk.until(on(Screen::kAttract));
    kiosk.touch();
    EXPECT_TRUE(kiosk.until(on(Screen::kChoose)));
    if (chance() % 2 == 0) {
        EXPECT_TRUE(kiosk.press(Button::kFree));
    } else {
        EXPECT_TRUE(kiosk.press(Button::kTarget, static_cast<int>(chance() % 3)));
    }
    EXPECT_TRUE(kiosk.until([&] { return kiosk.shown_screen() == Screen::kThrow; }, kSlowly));
    kiosk.touch_clay(chance);
    if (chance() % 3 == 0) {
        EXPECT_TRUE(kiosk.press(Button::kUndo));
    }
    if (chance() % 4 == 0) {
        EXPECT_TRUE(kiosk.press(Button::kNewClay));
    }
    if (chance() % 3 == 0) {
        EXPECT_TRUE(kiosk.press(Button::kLanguages));
        EXPECT_TRUE(kiosk.press(Button::kLanguage, static_cast<int>(chance() % 3)));
        EXPECT_TRUE(kiosk.press(Button::kComfortDone));
    }
    if (chance() % 8 == 0) {
        // A visitor who walks away.
        EXPECT_TRUE(kiosk.until(on(Screen::kAttract), 0.1));
        return false;
    }
    EXPECT_TRUE(kiosk.throw_a_pot(chance));
    EXPECT_TRUE(kiosk.ends_throwing());
    EXPECT_TRUE(kiosk.fires_it(chance() % 2 == 0));
    EXPECT_TRUE(kiosk.press(Button::kGlaze, static_cast<int>(chance() % 6)));
    EXPECT_TRUE(kiosk.press(Button::kTakeGlaze));
    EXPECT_TRUE(kiosk.until(on(Screen::kYourPot)));
    EXPECT_TRUE(kiosk.press(Button::kKeep));
    EXPECT_TRUE(kiosk.until([&] { return kiosk.state().keeping.outcome != kiosk::Keeping::Outcome::kSaving; },
                            kSlowly));
    EXPECT_EQ(kiosk.state().keeping.outcome, kiosk::Keeping::Outcome::kKept);
    EXPECT_TRUE(kiosk.press(Button::kFinish));
    return true;
}

// Counts the pots; each must be valid.
std::size_t pots_in(const fs::path& gallery) {
    std::size_t count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(gallery)) {
        count += entry.path().filename() == "pot.png" ? 1U : 0U;
        if (entry.path().filename() != "pot.onggi") continue;
        const auto verdict = visitors::judge_session(entry.path().string());
        EXPECT_TRUE(verdict) << verdict.error().message;
        if (!verdict) continue;
        EXPECT_TRUE(verdict->is_pot) << entry.path() << " " << verdict->why_not << ": "
                                     << visitors::words_for(*verdict);
    }
    return count;
}

void keep_a_pot(UnseenKiosk& kiosk, std::mt19937& chance) {
    ASSERT_TRUE(kiosk.press(Button::kFree));
    ASSERT_TRUE(kiosk.until([&] { return kiosk.shown_screen() == Screen::kThrow; }, kSlowly));
    ASSERT_TRUE(kiosk.throw_a_pot(chance));
    ASSERT_TRUE(kiosk.ends_throwing());
    ASSERT_TRUE(kiosk.fires_it(true));
    ASSERT_TRUE(kiosk.press(Button::kTakeGlaze));
    ASSERT_TRUE(kiosk.press(Button::kKeep));
    ASSERT_TRUE(kiosk.until([&] { return kiosk.state().keeping.outcome == kiosk::Keeping::Outcome::kKept; },
                            kSlowly));
}

TEST(Visitors, AreOneVisitAndTwoCompletionsWhereTheyKeepTwoPots) {
    const test::TemporaryFolder folder;
    UnseenKiosk kiosk(folder.path());
    std::mt19937 chance(20261122);
    const std::string day = today();
    kiosk.touch();
    ASSERT_TRUE(kiosk.until([&] { return kiosk.screen() == Screen::kChoose; }));
    keep_a_pot(kiosk, chance);
    ASSERT_TRUE(kiosk.press(Button::kAnother));
    keep_a_pot(kiosk, chance);
    ASSERT_TRUE(kiosk.press(Button::kFinish));
    const auto counted = [&] {
        UseOfHour use = use_of(folder / "statistics", day).total();
        // Midnight may have come meanwhile.
        if (const std::string now = today(); now != day) use += use_of(folder / "statistics", now).total();
        return use;
    };
    EXPECT_TRUE(kiosk.until([&] { return counted().visits == 1; }));
    const UseOfHour use = counted();
    EXPECT_EQ(use.breaks, 1);
    EXPECT_EQ(use.thrown, 1);
    EXPECT_EQ(use.kept, 2);
    EXPECT_GT(use.dwell_s, 0);
    EXPECT_EQ(pots_in(folder.path()), 2U);
}

TEST(Visitors, LeaveMemoryHandlesThreadsAndDiskAsTheyWereAndEveryPotOnTheShelf) {
    const test::TemporaryFolder folder;
    const int count = wanted("ONGGI_VISITS", 6);
    const int hours = wanted("ONGGI_HOURS", 0);
    const int minutes = wanted("ONGGI_MINUTES", 0);
    const auto seed = static_cast<unsigned>(wanted("ONGGI_SEED", 20261122));
    constexpr int kPotsOfASoak = 8;
    UnseenOptions options;
    options.real_time = minutes > 0;
    // A soak runs at the lowest priority (nice 19) and may have to wait long.
    if (minutes > 0) options.patience = std::chrono::minutes(10);
    if (minutes > 0 || hours > 0) options.most_pots = kPotsOfASoak;  // the shelf is soon full, and stays so
    const auto most_pots = static_cast<std::size_t>(options.most_pots);
    UnseenKiosk kiosk(folder.path(), std::move(options));
    std::mt19937 chance(seed);
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(minutes);
    const double begun_s = kiosk.now_s();
    std::size_t to_keep = 0;
    std::vector<stress::Figures> figures;
    int number = 0;
    for (; number < count || std::chrono::steady_clock::now() < end; ++number) {
        to_keep += visit(kiosk, chance) ? 1U : 0U;
        if (HasFailure()) FAIL() << "in visit " << number + 1 << " of seed " << seed;
        // No visitor for a while.
        constexpr double kAFrameS = 1.0;
        const double next_s = begun_s + 3600.0 * hours * (number + 1) / count;
        kiosk.until([&] { return kiosk.now_s() >= next_s; }, kAFrameS);
        // The keeper works beside us and may have a file open just now.
        kiosk.until([&] { return kiosk.screen() == Screen::kAttract; });
        figures.push_back(stress::figures_of_this_process(folder.path()));
        if (number % 10 == 9) {
            const stress::Figures& now = figures.back();
            std::printf("visit %d, %.2f h: %.0f kB, %.0f handles, %.0f threads, %.0f kB of disk\n",
                        number + 1, (kiosk.now_s() - begun_s) / 3600.0, now.resident_kb, now.handles,
                        now.threads, now.disk_kb);
            std::fflush(stdout);
        }
    }
    EXPECT_EQ(pots_in(folder.path()), std::min(to_keep, most_pots)) << "every pot is kept, and no other";
    std::printf("seed %u: %d visits in %.2f h of theirs, %zu pots kept\n", seed, number,
                (kiosk.now_s() - begun_s) / 3600.0, to_keep);
    // Caches, pools and the shelf fill up first.
    const std::size_t warm = std::min(figures.size(), std::max<std::size_t>(2, figures.size() / 5));
    figures.erase(figures.begin(), figures.begin() + static_cast<std::ptrdiff_t>(warm));
    stress::expect_flat(figures);
    for (const stress::Figures& one : figures)
        EXPECT_LE(one.handles, figures.front().handles + 2) << "files stay open";
}

}  // namespace
}  // namespace onggi::app

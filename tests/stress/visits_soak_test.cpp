// One scripted visitor after another. Memory and handles stay flat, and every pot that was to be kept is
// kept. A few visitors in ./check; ONGGI_VISITS=200 for the long run.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include "tests/stress/unseen_kiosk.h"
#include "tests/support/process_hold.h"
#include "tests/support/temporary_folder.h"
#include "tests/visitors/judge.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;
using kiosk::Button;
using kiosk::Screen;

// A pot is saved in real time, and the visit's must not run away from it into attract.
constexpr double kSlowly = 0.002;

int visits() {
    const char* wanted = std::getenv("ONGGI_VISITS");
    return wanted != nullptr ? std::atoi(wanted) : 6;
}

// From attract to attract. True where a pot was to be kept.
bool visit(UnseenKiosk& kiosk, std::mt19937& chance) {
    const auto on = [&](Screen screen) { return [&kiosk, screen] { return kiosk.screen() == screen; }; };
    kiosk.until(on(Screen::kAttract));
    kiosk.point(0.5 * kWidth, 0.5 * kHeight);
    kiosk.hold(true);
    kiosk.frame();
    kiosk.hold(false);
    EXPECT_TRUE(kiosk.until(on(Screen::kChoose)));
    if (chance() % 2 == 0) {
        EXPECT_TRUE(kiosk.press(Button::kFree));
    } else {
        EXPECT_TRUE(kiosk.press(Button::kTarget, static_cast<int>(chance() % 4)));
    }
    EXPECT_TRUE(kiosk.until([&] { return kiosk.shown_screen() == Screen::kThrow; }));
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
        // Somebody who just walks away.
        EXPECT_TRUE(kiosk.until(on(Screen::kAttract), 0.1));
        return false;
    }
    EXPECT_TRUE(kiosk.throw_a_pot(chance));
    EXPECT_TRUE(kiosk.press(Button::kDone));
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

// How many there are; each has to be one.
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
    ASSERT_TRUE(kiosk.until([&] { return kiosk.shown_screen() == Screen::kThrow; }));
    ASSERT_TRUE(kiosk.throw_a_pot(chance));
    ASSERT_TRUE(kiosk.press(Button::kDone));
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
    kiosk.touch();
    ASSERT_TRUE(kiosk.until([&] { return kiosk.screen() == Screen::kChoose; }));
    keep_a_pot(kiosk, chance);
    ASSERT_TRUE(kiosk.press(Button::kAnother));
    keep_a_pot(kiosk, chance);
    ASSERT_TRUE(kiosk.press(Button::kFinish));
    const fs::path statistics = folder / "statistics";
    EXPECT_TRUE(kiosk.until([&] { return use_of(statistics, today()).total().visits == 1; }));
    const UseOfHour use = use_of(statistics, today()).total();
    EXPECT_EQ(use.breaks, 1);
    EXPECT_EQ(use.thrown, 1);
    EXPECT_EQ(use.kept, 2);
    EXPECT_GT(use.dwell_s, 0);
    EXPECT_EQ(pots_in(folder.path()), 2U);
}

TEST(Visitors, LeaveMemoryAndHandlesAsTheyWereAndEveryPotOnTheShelf) {
    const test::TemporaryFolder folder;
    UnseenKiosk kiosk(folder.path());
    std::mt19937 chance(20261122);
    const int count = visits();
    const int warm = std::max(2, count / 5);  // caches, pools and the shelf of the day fill up first
    std::size_t to_keep = 0;
    long handles = 0;
    double sum_x = 0.0;
    double sum_y = 0.0;
    double sum_xx = 0.0;
    double sum_xy = 0.0;
    double first_kb = 0.0;
    for (int number = 0; number < count; ++number) {
        to_keep += visit(kiosk, chance) ? 1U : 0U;
        if (HasFailure()) FAIL() << "in visit " << number + 1;
        if (number == warm) handles = test::open_handles();
        if (number == warm) first_kb = test::resident_kb();
        if (number < warm) continue;
        // The keeper works beside us and may have files open just now, and have had one when we counted.
        EXPECT_TRUE(kiosk.until([&] { return test::open_handles() <= handles + 1; }))
            << "after visit " << number + 1 << ": expected " << handles << " open files, found "
            << test::open_handles();
        const double x = number - warm;
        const double y = test::resident_kb();
        sum_x += x;
        sum_y += y;
        sum_xx += x * x;
        sum_xy += x * y;
    }
    EXPECT_EQ(pots_in(folder.path()), to_keep) << "every pot is kept, and no other";
    const double n = count - warm;
    const double slope_kb = n > 1 ? (n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x) : 0.0;
    std::printf("%d visits, %zu pots kept; resident %.0f kB, then %+.1f kB a visit; %ld handles\n", count,
                to_keep, first_kb, slope_kb, test::open_handles());
    if (count >= 100) {
        EXPECT_LT(slope_kb, 40.0) << "memory grows";
    }
}

}  // namespace
}  // namespace onggi::app

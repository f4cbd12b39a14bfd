// The machine's clock is wrong or is corrected while the kiosk runs: a start in 1970 without a battery; a
// step by the network; summer time; the end of 32 bits. Nothing is lost or counted twice.
#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <set>

#include "game/app/kiosk/gallery/kiosk_gallery.h"
#include "game/app/kiosk/gallery/wall_of_the_day.h"
#include "game/app/kiosk/health/kiosk_statistics.h"
#include "game/app/kiosk/kiosk_settings.h"
#include "game/app/kiosk/staff/kiosk_staff.h"
#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kHourS = 3600;
constexpr std::int64_t kSecondsOf32Bits = 2'147'483'647;
// Berlin, 2026: summer time begins on 29 March at 01:00 UTC, and ends on 25 October at 01:00 UTC.
constexpr std::int64_t kSpringS = 1'774'746'000;
constexpr std::int64_t kAutumnS = 1'792'890'000;

// Sets the time zone while it lives.
class Standing {
  public:
    explicit Standing(const char* zone) {
        if (const char* before = std::getenv("TZ")) before_ = before;
        ::setenv("TZ", zone, 1);
        ::tzset();
    }
    Standing(const Standing&) = delete;
    Standing& operator=(const Standing&) = delete;
    ~Standing() {
        if (before_.empty()) {
            ::unsetenv("TZ");
        } else {
            ::setenv("TZ", before_.c_str(), 1);
        }
        ::tzset();
    }

  private:
    std::string before_;
};
// In POSIX form, which needs no zone tables.
constexpr const char* kBerlin = "CET-1CEST,M3.5.0,M10.5.0/3";

TEST(AClockThatJumps, CountsEveryVisitOnceOnTheDayThatItTells) {
    const Standing berlin(kBerlin);
    const test::TemporaryFolder folder;
    const auto visit = [&](std::int64_t now_s) {
        ASSERT_TRUE(note_visit(folder.path(), {.dwell_s = 60, .kept = 1}, now_s));
        ASSERT_TRUE(note_attract_break(folder.path(), now_s));
    };
    const std::int64_t noon_s = kAutumnS + 10 * kHourS;
    visit(60);                       // 1970
    visit(noon_s);                   // the network tells it the time
    visit(noon_s - 24 * kHourS);     // which was wrong by a day
    visit(noon_s + 1);               // and is right again
    visit(kSecondsOf32Bits);         // the last second of 32 bits
    visit(kSecondsOf32Bits + 3600);  // and long after
    EXPECT_EQ(use_of(folder.path(), "1970-01-01").total().visits, 1);
    EXPECT_EQ(use_of(folder.path(), "2026-10-25").total().visits, 2);
    EXPECT_EQ(use_of(folder.path(), "2026-10-25").total().breaks, 2);
    EXPECT_EQ(use_of(folder.path(), "2026-10-24").total().visits, 1);
    EXPECT_EQ(use_of(folder.path(), "2038-01-19").total().visits, 2);
}

TEST(AClockThatJumps, KnowsTheHourThatIsTwiceAndTheOneThatIsNot) {
    const Standing berlin(kBerlin);
    const test::TemporaryFolder folder;
    for (const std::int64_t now_s : {kAutumnS - 1800, kAutumnS + 1800})  // 02:30 both
        ASSERT_TRUE(note_visit(folder.path(), {.dwell_s = 60}, now_s));
    EXPECT_EQ(use_of(folder.path(), "2026-10-25").hours[2].visits, 2);
    for (const std::int64_t now_s : {kSpringS - 1800, kSpringS + 1800})  // 01:30 and 03:30
        ASSERT_TRUE(note_visit(folder.path(), {.dwell_s = 60}, now_s));
    const UseOfDay spring = use_of(folder.path(), "2026-03-29");
    EXPECT_EQ(spring.hours[1].visits, 1);
    EXPECT_EQ(spring.hours[2].visits, 0);
    EXPECT_EQ(spring.hours[3].visits, 1);
}

TEST(AClockThatJumps, OpensAndClosesByTheClockOnTheWall) {
    const Standing berlin(kBerlin);
    kiosk::Config config;
    config.hours.opens_min = 9 * 60;
    config.hours.closes_min = 18 * 60;
    const auto open_at = [&](std::int64_t now_s) { return kiosk::is_open(config, minute_of_day_at(now_s)); };
    // Nine by the clock is eight hours after midnight on a day in spring that has 23 of them, ten in autumn.
    const auto opens_s = [&](std::int64_t midnight_s) {
        std::int64_t now_s = midnight_s;
        while (!open_at(now_s))
            now_s += 60;
        return now_s - midnight_s;
    };
    EXPECT_EQ(opens_s(kSpringS - 2 * kHourS), 8 * kHourS);
    EXPECT_EQ(opens_s(kAutumnS - 3 * kHourS), 10 * kHourS);
    EXPECT_TRUE(open_at(10 * kHourS)) << "1970, eleven o'clock";
    EXPECT_EQ(minute_of_day_at(kSecondsOf32Bits + 1), 4 * 60 + 14);
}

TEST(AClockThatJumps, LeavesEveryPotItsOwnFolderAndAllListed) {
    const test::TemporaryFolder folder;
    std::set<std::string> days;
    for (const std::int64_t now_s :
         {std::int64_t{60}, kAutumnS, kAutumnS - 24 * kHourS, kSecondsOf32Bits + kHourS}) {
        days.insert(day_of(now_s));
        fs::create_directories(folder.path() / day_of(now_s) / "pot-001");
    }
    EXPECT_EQ(days.size(), 4U);
    const auto pots = kept_pots(folder.path());
    ASSERT_EQ(pots.size(), 4U);
    EXPECT_TRUE(pots.front().name.starts_with("2038-01-19/"));
    EXPECT_TRUE(pots.back().name.starts_with("1970-01-01/"));
}

TEST(AClockThatJumps, FindsTheWallOfTheDayAgainWhenItHasBeenSetRight) {
    const test::TemporaryFolder folder;
    const auto pot = [](const char* name) {
        return WallPot{.gallery_name = name,
                       .glaze = 1,
                       .shape = pot::hollowed({{40, 0}, {55, 50}, {45, 100}}, 5.0F, 8.0F)};
    };
    WallOfTheDay before(folder / "wall.json");
    ASSERT_TRUE(before.put(pot("2026-11-25/pot-001"), "2026-11-25"));
    // Restarted without a battery, and before the network.
    WallOfTheDay wall(folder / "wall.json");
    ASSERT_TRUE(wall.open("1970-01-01"));
    EXPECT_EQ(wall.pots().size(), 1U);
    ASSERT_TRUE(wall.turn_to("2026-11-25"));
    ASSERT_EQ(wall.pots().size(), 1U);
    // The same where somebody hangs a pot before the wheel has looked at the clock.
    WallOfTheDay quick(folder / "wall.json");
    ASSERT_TRUE(quick.open("1970-01-01"));
    ASSERT_TRUE(quick.put(pot("2026-11-25/pot-002"), "2026-11-25"));
    EXPECT_EQ(quick.pots().size(), 2U);
    // At midnight nothing of the day stays on the disk.
    ASSERT_TRUE(quick.turn_to("2026-11-26"));
    EXPECT_TRUE(quick.pots().empty());
    EXPECT_EQ(test::content_of(folder / "wall.json").find("pot-001"), std::string::npos);
}

}  // namespace
}  // namespace onggi::app

// A day of visitors, and the next: codes run out, the disk stays flat.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "game/app/sharing/page_store.h"
#include "game/sharing/outbox.h"
#include "tests/support/shared_pot_samples.h"
#include "tests/support/temporary_folder.h"

namespace onggi::sharing {
namespace {

namespace fs = std::filesystem;

std::uint64_t bytes_below(const fs::path& folder) {
    std::uint64_t sum = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) sum += entry.file_size();
    return sum;
}

TEST(OutboxOverDays, LetsCodesRunOutAndKeepsTheDiskFlat) {
    const test::TemporaryFolder folder;
    constexpr std::int64_t kHour = 3600;
    constexpr std::size_t kMostPots = 12;
    auto outbox = Outbox::open(
        {.folder = folder / "box", .most_pots = kMostPots, .languages = support::three_languages()});
    ASSERT_TRUE(outbox);
    const app::PageStore store(folder / "box");
    SharedPot pot = support::full_pot("day");
    std::map<std::string, std::int64_t> ends;  // of every code there ever was
    std::uint64_t most_bytes = 0;
    std::uint64_t most_of_first_day = 0;
    for (std::int64_t hour = 0; hour < 3 * 24; ++hour) {
        const std::int64_t now = 1'000'000 + hour * kHour;
        const bool is_open = hour % 24 >= 10 && hour % 24 < 18;
        const std::int64_t closes = 1'000'000 + (hour / 24 * 24 + 18) * kHour;
        for (int visitor = 0; is_open && visitor < 2; ++visitor) {
            const auto code = outbox->put(pot, {.now_s = now + visitor, .expires_s = closes});
            ASSERT_TRUE(code) << code.error().message;
            ends[code->text()] = closes;
        }
        // Restarted in the middle of the day: nothing is lost.
        if (hour % 24 == 13) {
            auto again = Outbox::open(
                {.folder = folder / "box", .most_pots = kMostPots, .languages = support::three_languages()});
            ASSERT_TRUE(again);
            ASSERT_EQ(again->list()->size(), outbox->list()->size());
            outbox = std::move(again);
        }
        // The server checks the time itself, whether or not the kiosk has removed expired pots.
        std::size_t open_now = 0;
        for (const auto& [text, end] : ends) {
            const ShareCode code = *ShareCode::read_exactly(text);
            const bool is_there = static_cast<bool>(store.open(code, "pot.glb", now + 60));
            open_now += is_there ? 1 : 0;
            ASSERT_FALSE(is_there && now + 60 >= end) << text << " at hour " << hour;
        }
        ASSERT_LE(open_now, kMostPots);
        const std::int64_t visitors = is_open ? 2 * (hour % 24 - 9) : 0;
        ASSERT_GE(open_now, std::min(kMostPots, static_cast<std::size_t>(visitors)));
        ASSERT_TRUE(outbox->expire(now + 60));
        most_bytes = std::max(most_bytes, bytes_below(folder / "box"));
        if (hour == 23) most_of_first_day = most_bytes;
        ASSERT_TRUE(hour % 24 < 18 || outbox->list()->empty());
    }
    EXPECT_EQ(ends.size(), 3U * 8 * 2);
    // Other codes pack a few bytes better or worse.
    EXPECT_LT(most_bytes, most_of_first_day + 1000) << "no day takes more than the first";
    EXPECT_LT(most_bytes, 1'500'000U) << "twelve pots of some 60 kB, and the files outside them";
}

// Seconds since 1970 of a day's noon.
constexpr std::int64_t kNoonS = 1'795'608'000;  // 2026-11-25
constexpr std::int64_t kHourS = 3600;
constexpr std::int64_t kDayS = 24 * kHourS;

class OutboxUnderAnyClock : public testing::Test {
  protected:
    std::string put(std::int64_t now_s, std::int64_t stays_s = 6 * kHourS) {
        const auto code = outbox_.put(support::full_pot("clock"), {now_s, now_s + stays_s});
        EXPECT_TRUE(code) << code.error().message;
        return code ? code->text() : "";
    }
    [[nodiscard]] bool is_served(const std::string& code, std::int64_t now_s) const {
        const app::PageStore store(folder_ / "box");
        return static_cast<bool>(store.open(*ShareCode::read_exactly(code), "pot.glb", now_s));
    }

    test::TemporaryFolder folder_;
    Outbox outbox_ =
        Outbox::open({.folder = folder_ / "box", .most_pots = 3, .languages = support::three_languages()})
            .value();
};

TEST_F(OutboxUnderAnyClock, LosesNoPotWhenAMachineWithoutABatteryStartsIn1970) {
    const std::string code = put(kNoonS);
    ASSERT_TRUE(outbox_.expire(60));
    EXPECT_TRUE(is_served(code, 60));
    ASSERT_TRUE(outbox_.expire(kNoonS + kHourS)) << "the network has told it the time";
    EXPECT_TRUE(is_served(code, kNoonS + kHourS));
    EXPECT_FALSE(is_served(code, kNoonS + 7 * kHourS));
}

TEST_F(OutboxUnderAnyClock, RemovesPotsSharedInTheWrongYear) {
    const std::string past = put(120);
    EXPECT_TRUE(is_served(past, 180));
    const std::string future = put(kNoonS + 3650 * kDayS);
    EXPECT_FALSE(is_served(past, kNoonS));
    EXPECT_FALSE(is_served(future, kNoonS)) << "or it would stay ten years";
    const std::string code = put(kNoonS);
    EXPECT_EQ(outbox_.list()->size(), 1U);
    EXPECT_TRUE(is_served(code, kNoonS));
}

TEST_F(OutboxUnderAnyClock, KeepsTheNewestWhenTheClockStepsBackAnHour) {
    for (int pot = 0; pot < 3; ++pot)
        put(kNoonS + pot);
    const std::string code = put(kNoonS - kHourS);
    EXPECT_EQ(outbox_.list()->size(), 3U);
    EXPECT_TRUE(is_served(code, kNoonS - kHourS)) << "who has just been shown a code finds a pot there";
}

TEST_F(OutboxUnderAnyClock, MakesRoomByAgeUnderAClockThatHasGoneBackToo) {
    const std::string oldest = put(kNoonS);
    const std::string older = put(kNoonS + 1);
    put(kNoonS + 2);
    const std::string first = put(60);  // 1970, after a power cut
    const std::string second = put(120);
    EXPECT_FALSE(is_served(oldest, 180));
    EXPECT_FALSE(is_served(older, 180));
    EXPECT_TRUE(is_served(first, 180)) << "a newcomer takes no newcomer's place";
    EXPECT_TRUE(is_served(second, 180));
}

TEST_F(OutboxUnderAnyClock, KeepsAPageForItsTimeWhoseClockWasNotSet) {
    const std::string code = put(60);
    EXPECT_TRUE(is_served(code, kNoonS)) << "the network has set the clock, but no expiry has run yet";
    ASSERT_TRUE(outbox_.expire(kNoonS));
    EXPECT_TRUE(is_served(code, kNoonS + 5 * kHourS));
    EXPECT_FALSE(is_served(code, kNoonS + 7 * kHourS));
    ASSERT_TRUE(outbox_.expire(kNoonS + 7 * kHourS));
    EXPECT_TRUE(outbox_.list()->empty());
}

TEST_F(OutboxUnderAnyClock, GoesOnAfter2038) {
    constexpr std::int64_t kSecondsOf32Bits = 2'147'483'647;
    const std::string code = put(kSecondsOf32Bits - 60);
    ASSERT_TRUE(outbox_.expire(kSecondsOf32Bits + 60));
    EXPECT_TRUE(is_served(code, kSecondsOf32Bits + 60));
    EXPECT_FALSE(is_served(code, kSecondsOf32Bits + 6 * kHourS));
}

TEST_F(OutboxUnderAnyClock, KeepsAWeekWhereTheHouseGivesOne) {
    const std::string code = put(kNoonS, 168 * kHourS);
    EXPECT_TRUE(is_served(code, kNoonS - kHourS)) << "a summer's hour back";
    EXPECT_TRUE(is_served(code, kNoonS + 167 * kHourS));
}

}  // namespace
}  // namespace onggi::sharing

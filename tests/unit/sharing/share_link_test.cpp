#include "game/sharing/share_link.h"

#include <gtest/gtest.h>

#include "game/sharing/page_folder.h"

namespace onggi::sharing {
namespace {

constexpr std::int64_t kHour = 3600;
constexpr std::int64_t kKorea = 9 * kHour;
constexpr std::int64_t kMidnight = 1'795'446'000;  // 2026-11-24 00:00 in Korea

TEST(ShareLink, NamesThePage) {
    const ShareCode code = *ShareCode::read("K73FQ9TX");
    EXPECT_EQ(page_url(base_url("10.0.0.5", 8080), code), "http://10.0.0.5:8080/K73FQ9TX/");
    EXPECT_EQ(page_url(base_url("10.0.0.5", 80), code), "http://10.0.0.5/K73FQ9TX/");
    EXPECT_EQ(base_url("fd00::5", 8080), "http://[fd00::5]:8080");
    EXPECT_EQ(page_url("https://museum.org/pots/", code), "https://museum.org/pots/K73FQ9TX/");
}

TEST(ShareLink, WritesTheWifiAsCamerasReadIt) {
    kiosk::Config config;
    EXPECT_EQ(wifi_text(config), "");
    config.sharing.wifi_name = "Museum";
    EXPECT_EQ(wifi_text(config), "WIFI:T:nopass;S:Museum;;");
    config.sharing.wifi_name = "Pots; and \"wheels\"";
    config.sharing.wifi_key = "a:b\\c,ddd";
    EXPECT_EQ(wifi_text(config), "WIFI:T:WPA;S:Pots\\; and \\\"wheels\\\";P:a\\:b\\\\c\\,ddd;;");
}

TEST(ShareLink, SaysUntilWhen) {
    kiosk::Config config;
    const auto leaves = [&](std::int64_t hour, std::int64_t minute = 0) {
        const std::int64_t now = kMidnight + hour * kHour + minute * 60;
        return share_time(config, now, kKorea).expires_s;
    };
    EXPECT_EQ(leaves(10), kMidnight + 24 * kHour) << "always open: the end of the day";
    EXPECT_EQ(leaves(23, 30), kMidnight + 24 * kHour + 30 * 60) << "an hour at least";
    config.hours = {10 * 60, 18 * 60};
    EXPECT_EQ(leaves(10), kMidnight + 18 * kHour);
    EXPECT_EQ(leaves(17, 30), kMidnight + 18 * kHour + 30 * 60);
    EXPECT_EQ(leaves(18, 5), kMidnight + 19 * kHour + 5 * 60) << "closed already";
    config.hours = {18 * 60, 60};
    EXPECT_EQ(leaves(20), kMidnight + 25 * kHour) << "a night at the museum";
    config.sharing.hours = 5;
    EXPECT_EQ(leaves(20), kMidnight + 25 * kHour);
    EXPECT_EQ(leaves(1), kMidnight + 6 * kHour);
}

TEST(ShareLink, SaysItInWordsOfTheClock) {
    const auto said = [](std::int64_t now, std::int64_t expires) {
        return gone_at({.now_s = kMidnight + now, .expires_s = kMidnight + expires, .utc_offset_s = kKorea});
    };
    EXPECT_EQ(said(10 * kHour, 18 * kHour).text, "18:00");
    EXPECT_TRUE(said(10 * kHour, 18 * kHour).is_today);
    EXPECT_EQ(said(10 * kHour, 24 * kHour).text, "24:00");
    EXPECT_TRUE(said(10 * kHour, 24 * kHour).is_today);
    EXPECT_EQ(said(10 * kHour, 34 * kHour).text, "2026-11-25, 10:00");
    EXPECT_FALSE(said(10 * kHour, 34 * kHour).is_today);
    EXPECT_EQ(gone_at({.now_s = 0, .expires_s = 1'709'164'800, .utc_offset_s = 0}).text, "2024-02-28, 24:00");
    EXPECT_EQ(gone_at({.now_s = 0, .expires_s = 1'709'209'800, .utc_offset_s = 0}).text, "2024-02-29, 12:30");
    EXPECT_EQ(gone_at({.now_s = 0, .expires_s = 1'735'649'999, .utc_offset_s = 0}).text, "2024-12-31, 12:59");
}

}  // namespace
}  // namespace onggi::sharing

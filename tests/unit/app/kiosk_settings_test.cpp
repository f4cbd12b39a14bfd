// A kiosk's settings at start: its file, the command line, the volume set by the staff.
#include "game/app/kiosk/kiosk_settings.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;

void put(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text;
}

kiosk::Config config_of(const fs::path& folder) {
    kiosk::Config config;
    config.gallery.folder = folder.string();
    return config;
}

struct KioskSettingsTest : testing::Test {
    const test::TemporaryFolder folder;
};

TEST_F(KioskSettingsTest, BeginWithTheLanguagesInTheOrderOfTheFile) {
    put(folder / "kiosk.toml", "[languages]\norder = [\"ar\", \"ko\"]\nfirst = \"ko\"\n");
    const auto settings = load_settings((folder / "kiosk.toml").string());
    ASSERT_TRUE(settings) << settings.error().message;
    ASSERT_EQ(settings->languages->size(), 2U);
    EXPECT_EQ(settings->languages->front().code(), "ar");
    EXPECT_EQ(settings->rules.language_count, 2);
    EXPECT_EQ(settings->rules.default_language, 1);
}

TEST_F(KioskSettingsTest, ReplaceMissingTextsByEnglishAndReportTheirNumber) {
    put(folder / "words/de.tsv", "key\ttext\tspoken\tcheck\nname\tDeutsch\t\t\n");
    put(folder / "kiosk.toml",
        "[languages]\norder = [\"de\", \"en\"]\nfolder = \"" + (folder / "words").string() + "\"\n");
    const auto settings = load_settings((folder / "kiosk.toml").string());
    ASSERT_TRUE(settings) << settings.error().message;
    const kiosk::Language& german = settings->languages->front();
    EXPECT_EQ(german.shown("name"), "Deutsch");
    EXPECT_EQ(german.shown("ctl.done"), settings->languages->back().shown("ctl.done"));
    ASSERT_FALSE(settings->remarks.empty());
    EXPECT_NE(settings->remarks.front().find("de.tsv: expected every text, found "), std::string::npos);
    EXPECT_NE(settings->remarks.front().find("English stands in"), std::string::npos);
}

TEST_F(KioskSettingsTest, IgnoreOnlyAnInvalidTableOfWords) {
    put(folder / "words/ko.tsv", "key\ttext\tspoken\tcheck\nother\t말\n");
    put(folder / "words/pt.tsv", "no table\n");
    put(folder / "kiosk.toml", "[languages]\norder = [\"pt\", \"ko\"]\nfirst = \"ko\"\nfolder = \"" +
                                   (folder / "words").string() + "\"\n[staff]\nlocked = true\n");
    const auto settings = load_settings((folder / "kiosk.toml").string());
    ASSERT_TRUE(settings) << settings.error().message;
    EXPECT_TRUE(settings->config.staff.locked);
    ASSERT_EQ(settings->languages->size(), 1U);
    EXPECT_EQ(settings->languages->front().code(), "ko");
    EXPECT_EQ(settings->rules.default_language, 0);
    ASSERT_GE(settings->remarks.size(), 2U);
    EXPECT_NE(settings->remarks[0].find(
                  "pt.tsv:1: expected the header key,text,spoken,check, found 'no table'; the kiosk"),
              std::string::npos)
        << settings->remarks[0];
    EXPECT_NE(settings->remarks[1].find(
                  "ko.tsv:2: expected a key that the program knows, found 'other'; the built-in"),
              std::string::npos)
        << settings->remarks[1];
    put(folder / "kiosk.toml",
        "[languages]\norder = [\"pt\"]\nfirst = \"pt\"\nfolder = \"" + (folder / "words").string() + "\"\n");
    EXPECT_EQ(load_settings((folder / "kiosk.toml").string())->languages->front().code(), "en");
}

TEST_F(KioskSettingsTest, RejectAMissingOrInvalidFile) {
    EXPECT_FALSE(load_settings((folder / "none.toml").string()));
    put(folder / "bad.toml", "[sound]\nvolume = 11\n");
    const auto refused = load_settings((folder / "bad.toml").string());
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("bad.toml, line 2"), std::string::npos);
}

TEST_F(KioskSettingsTest, GoOnWithTheHousesWhereTheMuseumsCannotBeRead) {
    put(folder / "museum.toml", "[sound]\nvolume = 11\n");
    put(folder / "house.toml", "[staff]\nlocked = true\n");
    const auto settings = load_settings((folder / "museum.toml").string(), (folder / "house.toml").string());
    ASSERT_TRUE(settings) << settings.error().message;
    EXPECT_TRUE(settings->config.staff.locked);
    ASSERT_FALSE(settings->remarks.empty());
    EXPECT_NE(settings->remarks.front().find("museum.toml, line 2"), std::string::npos);
    EXPECT_NE(settings->remarks.front().find("house.toml"), std::string::npos);
    EXPECT_FALSE(load_settings((folder / "museum.toml").string(), (folder / "none.toml").string()));
    put(folder / "museum.toml", "[sound]\nvolume = 1\n");
    const auto mended = load_settings((folder / "museum.toml").string(), (folder / "house.toml").string());
    ASSERT_TRUE(mended);
    EXPECT_FALSE(mended->config.staff.locked);
}

TEST_F(KioskSettingsTest, KeepTheStaffsSettingsOnlyIfConfigured) {
    KioskSettings settings;
    settings.config = config_of(folder.path());
    settings.languages = std::make_shared<const std::vector<kiosk::Language>>(kiosk::built_in_languages());
    settings.config.sound.remember_staff = true;
    take_kept_house(settings);
    EXPECT_EQ(settings.config.sound.volume, 3) << "none has been set yet";
    ASSERT_TRUE(keep_house(statistics_folder(settings.config), {1, "ar"}));
    settings.config.sound.remember_staff = false;
    take_kept_house(settings);
    EXPECT_EQ(settings.config.sound.volume, 3);
    settings.config.sound.remember_staff = true;
    take_kept_house(settings);
    EXPECT_EQ(settings.config.sound.volume, 1);
    EXPECT_EQ(settings.rules.default_volume, 1);
    EXPECT_EQ((*settings.languages)[static_cast<std::size_t>(settings.rules.default_language)].code(), "ar");
    ASSERT_TRUE(keep_house(statistics_folder(settings.config), {2, "pt"}));
    take_kept_house(settings);
    EXPECT_EQ(settings.rules.default_volume, 2);
    EXPECT_EQ((*settings.languages)[static_cast<std::size_t>(settings.rules.default_language)].code(), "ar")
        << "a language that is no longer there changes nothing";
    EXPECT_TRUE(settings.remarks.empty());
}

TEST_F(KioskSettingsTest, ReportAnInvalidKeptVolumeAndUseTheirOwn) {
    KioskSettings settings;
    settings.config = config_of(folder.path());
    settings.config.sound.remember_staff = true;
    fs::create_directories(statistics_folder(settings.config));
    std::ofstream(statistics_folder(settings.config) / "staff.toml") << "[sound]\nvolume = 11\n";
    take_kept_house(settings);
    EXPECT_EQ(settings.config.sound.volume, 3);
    ASSERT_EQ(settings.remarks.size(), 1U);
    EXPECT_NE(settings.remarks.front().find("staff.toml, line 2: expected a whole number, 0 to 5"),
              std::string::npos)
        << settings.remarks.front();
}

TEST_F(KioskSettingsTest, ReportTextsAndTargetsTooSmallOnTheirPanel) {
    kiosk::Config config;
    EXPECT_TRUE(panel_lacks(config, 1920, 1080).empty()) << "24 inches at 600 mm";
    EXPECT_TRUE(panel_lacks(config, 3840, 2160).empty());
    EXPECT_TRUE(panel_lacks(config, 1080, 1920).empty());
    config.screen.distance_mm = 800.0;
    ASSERT_EQ(panel_lacks(config, 1920, 1080).size(), 1U);
    EXPECT_EQ(panel_lacks(config, 1920, 1080).front(),
              "screen: expected capitals of 0.7 degrees, found 0.56 in the smallest words at 800 mm from 24 "
              "inches; a panel of 31 inches or a distance of 635 mm would do");
    config.screen.diagonal_inch = 15.6;
    ASSERT_EQ(panel_lacks(config, 1920, 1080).size(), 2U);
    config.screen.distance_mm = 400.0;  // near enough to read it, and too small to touch
    ASSERT_EQ(panel_lacks(config, 1920, 1080).size(), 1U);
    EXPECT_EQ(panel_lacks(config, 1920, 1080).front(),
              "screen: expected targets of 20 mm, found 13.5 in the smallest on 15.6 inches; a panel of 24 "
              "inches would do");
}

TEST(KioskTickRate, IsTheFinerOneWhereDeadlinesAreKeptUnlessTheSettingsSayAnother) {
    EXPECT_EQ(tick_rate_hz(0.0, true), 4000.0);
    EXPECT_EQ(tick_rate_hz(0.0, false), 1000.0);
    EXPECT_EQ(tick_rate_hz(10000.0, false), 10000.0);
    EXPECT_EQ(tick_rate_hz(500.0, true), 500.0);
}

}  // namespace
}  // namespace onggi::app

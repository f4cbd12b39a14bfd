// The statistics of visits: the recorded fields, nothing beyond them, and the staff's summary.
#include "game/app/kiosk/health/kiosk_statistics.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include "game/app/kiosk/gallery/kiosk_gallery.h"
#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

struct KioskStatisticsTest : testing::Test {
    const test::TemporaryFolder folder;
};

TEST_F(KioskStatisticsTest, KeepsALineAVisitUnderOneLineOfNames) {
    ASSERT_TRUE(note_visit(folder.path() / "use", {95, kiosk::Screen::kKeep, true, 2}));
    ASSERT_TRUE(note_visit(folder.path() / "use", {12, kiosk::Screen::kChoose, false, 0}));
    const std::string text = text_of(folder.path() / "use" / "visits.csv");
    const std::regex expected(
        "day,hour,dwell_s,ended_on,thrown,kept\n"
        "\\d{4}-\\d\\d-\\d\\d,\\d\\d,95,keep,1,2\n"
        "\\d{4}-\\d\\d-\\d\\d,\\d\\d,12,choose,0,0\n");
    EXPECT_TRUE(std::regex_match(text, expected)) << text;
}

TEST_F(KioskStatisticsTest, KeepsADayAndAnHourOfBreaksAndStarts) {
    ASSERT_TRUE(note_attract_break(folder.path()));
    ASSERT_TRUE(note_attract_break(folder.path()));
    ASSERT_TRUE(note_start(folder.path()));
    const std::regex two("day,hour\n(\\d{4}-\\d\\d-\\d\\d,\\d\\d\n){2}");
    EXPECT_TRUE(std::regex_match(text_of(folder.path() / "attract_breaks.csv"), two));
    const std::regex one("day,hour\n\\d{4}-\\d\\d-\\d\\d,\\d\\d\n");
    EXPECT_TRUE(std::regex_match(text_of(folder.path() / "starts.csv"), one));
}

TEST_F(KioskStatisticsTest, CountsPhonesWithoutIdentifyingThem) {
    ASSERT_TRUE(note_phones(folder.path(), {.codes = 1}));
    ASSERT_TRUE(note_phones(folder.path(), {.pages = 3, .models = 2, .prints = 1}));
    const std::regex expected(
        "day,hour,codes,pages,models,prints,films\n"
        "\\d{4}-\\d\\d-\\d\\d,\\d\\d,1,0,0,0,0\n"
        "\\d{4}-\\d\\d-\\d\\d,\\d\\d,0,3,2,1,0\n");
    EXPECT_TRUE(std::regex_match(text_of(folder.path() / "phones.csv"), expected));
}

TEST_F(KioskStatisticsTest, SaysWhereItCouldNotWrite) {
    std::ofstream(folder.path() / "taken") << "a file where a folder is wanted";
    const auto noted = note_visit(folder.path() / "taken", {1, kiosk::Screen::kThrow, true, 0});
    ASSERT_FALSE(noted);
    EXPECT_NE(noted.error().message.find("visits.csv"), std::string::npos);
}

TEST_F(KioskStatisticsTest, CountsADayByItsHours) {
    std::ofstream(folder.path() / "visits.csv") << "day,hour,dwell_s,ended_on,thrown,kept\n"
                                                   "2026-11-20,10,900,keep,1,1\n"
                                                   "2026-11-21,10,95,keep,1,2\n"
                                                   "2026-11-21,10,5,choose,0,0\n"
                                                   "2026-11-21,23,60,throw,1,0\n"
                                                   // Lines that this program did not write.
                                                   "2026-11-21,24,60,throw,1,0\n"
                                                   "2026-11-21,10,-60,throw,1,0\n"
                                                   "2026-11-21,10,60,throw,1\n"
                                                   "2026-11-210,10,60,throw,1,0\n"
                                                   "2026-11-21,10,60x,throw,1,0\n"
                                                   "2026-11-21,10,60,keep,1,2147483647\n"
                                                   "\n2026-11-21";
    std::ofstream(folder.path() / "attract_breaks.csv") << "day,hour\n2026-11-21,10\n2026-11-21,10\n"
                                                           "2026-11-21,10\n2026-11-20,10\n";
    std::ofstream(folder.path() / "starts.csv") << "day,hour\n2026-11-21,08\n2026-11-21,13\n";
    const UseOfDay use = use_of(folder.path(), "2026-11-21");
    EXPECT_EQ(use.hours[10], (UseOfHour{.breaks = 3, .visits = 2, .thrown = 1, .kept = 2, .dwell_s = 100}));
    EXPECT_EQ(use.hours[23], (UseOfHour{.breaks = 0, .visits = 1, .thrown = 1, .kept = 0, .dwell_s = 60}));
    EXPECT_EQ(use.total(), (UseOfHour{.breaks = 3, .visits = 3, .thrown = 2, .kept = 2, .dwell_s = 160}));
    EXPECT_EQ(use.starts, 2);
}

TEST_F(KioskStatisticsTest, ReadsItsFilesBackAndIsEmptyWithoutFiles) {
    EXPECT_EQ(use_of(folder.path() / "nowhere", today()), UseOfDay{});
    ASSERT_TRUE(note_visit(folder.path(), {95, kiosk::Screen::kKeep, true, 2}));
    ASSERT_TRUE(note_attract_break(folder.path()));
    ASSERT_TRUE(note_start(folder.path()));
    // For the day in the line itself: midnight may have passed meanwhile.
    const std::string visits = text_of(folder.path() / "visits.csv");
    const UseOfDay use = use_of(folder.path(), visits.substr(visits.find('\n') + 1, 10));
    EXPECT_EQ(use.total(), (UseOfHour{.breaks = 1, .visits = 1, .thrown = 1, .kept = 2, .dwell_s = 95}));
    EXPECT_EQ(use.starts, 1);
}

}  // namespace
}  // namespace onggi::app

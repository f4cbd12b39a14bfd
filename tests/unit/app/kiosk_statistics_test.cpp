// What is kept of a visit, and that it is no more than that.
#include "game/app/kiosk_statistics.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

TEST(KioskStatistics, KeepsALineAVisitUnderOneLineOfNames) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(note_visit(folder.path() / "use", {95, kiosk::Screen::kKeep, true}));
    ASSERT_TRUE(note_visit(folder.path() / "use", {12, kiosk::Screen::kChoose, false}));
    std::ifstream stream(folder.path() / "use" / "visits.csv");
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    const std::regex expected(
        "day,hour,dwell_s,ended_on,kept\n"
        "\\d{4}-\\d\\d-\\d\\d,\\d\\d,95,keep,1\n"
        "\\d{4}-\\d\\d-\\d\\d,\\d\\d,12,choose,0\n");
    EXPECT_TRUE(std::regex_match(text, expected)) << text;
}

TEST(KioskStatistics, SaysWhereItCouldNotWrite) {
    const test::TemporaryFolder folder;
    std::ofstream(folder.path() / "taken") << "a file where a folder is wanted";
    const auto noted = note_visit(folder.path() / "taken", {1, kiosk::Screen::kThrow, false});
    ASSERT_FALSE(noted);
    EXPECT_NE(noted.error().message.find("visits.csv"), std::string::npos);
}

}  // namespace
}  // namespace onggi::app

#include "game/app/finding.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include <filesystem>

#include "game/app/device_probes.h"
#include "game/app/system_probes.h"

namespace onggi::app {
namespace {

using Verdict = Finding::Verdict;

TEST(Findings, SayWhatALackCostsAndHowToMendIt) {
    const std::vector<Finding> findings{
        {.subject = "cores", .found = "two"},
        {.subject = "disk",
         .verdict = Verdict::kLacking,
         .found = "full",
         .cost = "nothing is kept",
         .remedy = "tidy up"},
    };
    EXPECT_EQ(findings_as_text(findings),
              "good     cores  two\n"
              "lacking  disk   full\n"
              "                costs: nothing is kept\n"
              "                mend: tidy up\n");
    EXPECT_TRUE(any_lacking(findings));
    EXPECT_FALSE(any_lacking(std::span(findings).first(1)));
}

TEST(SystemProbes, SeeAFolderThatIsNotThere) {
    EXPECT_EQ(probe_disk("/no/such/folder").verdict, Verdict::kLacking);
    EXPECT_NE(probe_disk("/no/such/folder").found.find("/no/such/folder"), std::string::npos);
}

TEST(SystemProbes, FindTheWorkshopOfThisSourceTreeOrSayWhatIsLost) {
    EXPECT_EQ(probe_workshop().verdict, Verdict::kGood) << probe_workshop().found;
    ::setenv("ONGGI_ASSETS", "/no/such/folder", 1);
    const Finding none = probe_workshop();
    ::unsetenv("ONGGI_ASSETS");
    EXPECT_EQ(none.verdict, Verdict::kLacking);
    EXPECT_NE(none.found.find("/no/such/folder"), std::string::npos);
    EXPECT_FALSE(none.cost.empty() || none.remedy.empty());
}

TEST(SystemProbes, NameTheFontsThatAreMissing) {
    const Finding nothing = probe_fonts({"/no/such/folder"});
    EXPECT_EQ(nothing.verdict, Verdict::kLacking);
    EXPECT_NE(nothing.found.find("NanumSquareRound"), std::string::npos);
    EXPECT_FALSE(nothing.cost.empty());
    EXPECT_NE(nothing.remedy.find("fonts-noto-core"), std::string::npos);
}

TEST(Findings, SayWhoHearsTheStopKey) {
    const Finding none = probe_stop_keys("/no/such/folder");
    EXPECT_EQ(none.verdict, Finding::Verdict::kNote);
    EXPECT_NE(none.found.find("the window alone"), std::string::npos) << none.found;
    EXPECT_NE(none.found.find("/no/such/folder"), std::string::npos);
}

TEST(SystemProbes, SayThatNoInverseServiceListensWithoutCallingItALack) {
    // Port 1 is nobody's.
    const Finding none = probe_inverse({.port = 1});
    EXPECT_EQ(none.verdict, Verdict::kNote);
    EXPECT_EQ(
        none.found,
        "Haply Inverse3: looked for at 127.0.0.1:1 while the wheel runs; not found now: nothing listens at "
        "127.0.0.1:1; its maker's service must be installed and run");
}

TEST(SystemProbes, AlwaysFindTheSimulatedTool) {
    const std::vector<Finding> devices = probe_haptic_devices();
    ASSERT_FALSE(devices.empty());
    EXPECT_NE(devices.front().found.find("simulated"), std::string::npos);
}

}  // namespace
}  // namespace onggi::app

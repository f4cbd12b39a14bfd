#include "game/app/command_line/finding.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

#include <filesystem>

#include "game/app/kiosk/kiosk_settings.h"
#include "game/app/sharing/listen_place.h"
#include "tests/support/held_port.h"
#include "tests/support/hostile_system.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

using Verdict = Finding::Verdict;

TEST(Findings, StateTheCostAndRemedyOfALack) {
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

TEST(SystemProbes, FindTheWorkshopOrReportItsLack) {
    EXPECT_EQ(probe_workshop().verdict, Verdict::kGood) << probe_workshop().found;
    ::setenv("ONGGI_ASSETS", "/no/such/folder", 1);
    const Finding none = probe_workshop();
    ::unsetenv("ONGGI_ASSETS");
    EXPECT_EQ(none.verdict, Verdict::kLacking);
    EXPECT_NE(none.found.find("/no/such/folder"), std::string::npos);
    EXPECT_FALSE(none.cost.empty() || none.remedy.empty());
}

TEST(SystemProbes, OpenTheRoomThatTheSettingsName) {
    const test::TemporaryFolder folder;
    const std::string settings = (folder / "kiosk.toml").string();
    const auto room = [&](const std::string& named) {
        test::put_file(settings, "[screen]\nroom = \"" + named + "\"\n");
        for (Finding& finding : probe_settings(settings)) {
            if (finding.subject == "room") return finding;
        }
        return Finding{.found = "nothing of a room"};
    };
    EXPECT_EQ(room("").found, "nothing of a room");
    const Finding found = room(test::in_checkout("assets/workshop"));
    EXPECT_EQ(found.verdict, Finding::Verdict::kGood) << found.found;
    const Finding lost = room("nowhere");
    EXPECT_EQ(lost.verdict, Finding::Verdict::kLacking);
    EXPECT_NE(lost.found.find("nowhere/cameras.json: no such file"), std::string::npos) << lost.found;
}

TEST(SystemProbes, NameTheFontsThatAreMissing) {
    const Finding nothing = probe_fonts({"/no/such/folder"}, kiosk::Config().languages.order);
    EXPECT_EQ(nothing.verdict, Verdict::kLacking);
    EXPECT_NE(nothing.found.find("NanumSquareRound"), std::string::npos);
    EXPECT_FALSE(nothing.cost.empty());
    EXPECT_EQ(nothing.remedy, "apt-get install fonts-nanum fonts-noto-core");

    const std::vector<std::string> german{"de"};
    EXPECT_EQ(probe_fonts({"/no/such/folder"}, german).remedy, nothing.remedy);
    const std::vector<std::string> japanese{"en", "ja"};
    const Finding more = probe_fonts({"/no/such/folder"}, japanese);
    EXPECT_NE(more.found.find("Noto Serif CJK JP"), std::string::npos) << more.found;
    EXPECT_EQ(more.found.find("Noto Serif CJK SC"), std::string::npos) << more.found;
    EXPECT_EQ(more.remedy, "apt-get install fonts-nanum fonts-noto-cjk fonts-noto-core");
}

TEST(SystemProbes, ReportTheKiosksSettingsOrTheirAbsence) {
    const test::TemporaryFolder folder;
    const std::string file = folder / "kiosk.toml";
    const std::vector<Finding> none = probe_settings("", file);
    ASSERT_EQ(none.size(), 1U);
    EXPECT_EQ(none[0].verdict, Verdict::kNote);
    EXPECT_EQ(none[0].found,
              "none in " + file + ": the kiosk starts with defaults unless --config names settings");

    const std::string gallery = folder / "not/yet/there";
    test::put_file(file,
                   "[languages]\norder = [\"ko\", \"en\"]\nfirst = \"ko\"\n[visit]\nforgiving = false\n"
                   "[hours]\nopens = \"09:30\"\ncloses = \"17:05\"\n[staff]\npin = \"1234\"\nlocked = true\n"
                   "[gallery]\nleast_free_mb = 1\nfolder = \"" +
                       gallery + "\"\n");
    const std::vector<Finding> usual = probe_settings("", file);
    ASSERT_EQ(usual.size(), 3U);
    EXPECT_EQ(usual[0].verdict, Verdict::kGood);
    EXPECT_EQ(usual[0].found, file +
                                  ": visits begin in ko, of ko, en; unforgiving clay; a PIN for the staff; "
                                  "locked; open 09:30 to 17:05");
    EXPECT_EQ(usual[0].found.find("1234"), std::string::npos) << "a PIN is private";
    EXPECT_EQ(usual[1].subject, "speech");
    EXPECT_NE(usual[1].verdict, Verdict::kLacking) << "nothing asks for it";
    EXPECT_EQ(usual[2].subject, "gallery");
    EXPECT_EQ(usual[2].verdict, Verdict::kGood) << usual[2].found;
    EXPECT_NE(usual[2].found.find(gallery), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder / "not")) << "it only looks";
}

TEST(SystemProbes, MissTheSpeechThatTheSettingsAskFor) {
    const test::TemporaryFolder folder;
    const std::string file = folder / "kiosk.toml";
    const auto speech = [&](const std::string& setting) {
        test::put_file(file, "[sound]\nspeech = \"" + setting + "\"\n");
        for (const Finding& finding : probe_settings(file))
            if (finding.subject == "speech") return finding;
        return Finding{};
    };
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", folder.path().c_str(), 1);
    const Finding asked = speech("on");
    EXPECT_EQ(asked.verdict, Verdict::kLacking) << asked.found;
    EXPECT_NE(asked.remedy.find("espeak-ng"), std::string::npos);
    EXPECT_EQ(speech("headphones").verdict, Verdict::kNote);
    EXPECT_EQ(speech("off").found, "off");
    ::setenv("PATH", path.c_str(), 1);
}

TEST(SystemProbes, ReportErrorsInTheKiosksSettings) {
    const test::TemporaryFolder folder;
    const std::string file = folder / "kiosk.toml";
    test::put_file(file, "[visit]\nforgivng = true\n");
    const std::vector<Finding> wrong = probe_settings(file);
    ASSERT_EQ(wrong.size(), 1U);
    EXPECT_EQ(wrong[0].verdict, Verdict::kLacking);
    EXPECT_EQ(wrong[0].found, load_settings(file).error().message);
    EXPECT_NE(wrong[0].found.find("line 2"), std::string::npos) << wrong[0].found;
    EXPECT_EQ(probe_settings(folder / "none.toml")[0].verdict, Verdict::kLacking) << "it was asked for";

    // A machine may have a disk of a million MB.
    test::put_file(file, "[gallery]\nleast_free_mb = 1000000\nfolder = \"" + folder.path().string() + "\"\n");
    const bool is_full = std::filesystem::space(folder.path()).available < 1'000'000'000'000;
    const std::vector<Finding> full = probe_settings(file);
    EXPECT_EQ(full.back().subject, "gallery");
    EXPECT_EQ(full.back().verdict, is_full ? Verdict::kLacking : Verdict::kGood);
    EXPECT_EQ(full.back().found.ends_with(", the settings require 1000000"), is_full) << full.back().found;
}

TEST(SystemProbes, SayWhetherPhonesFindSharedPots) {
    const test::TemporaryFolder folder;
    const std::string file = folder / "kiosk.toml";
    const auto sharing = [&](const std::string& lines) {
        test::put_file(file, "[gallery]\nleast_free_mb = 1\n[sharing]\noutbox = \"" + folder.path().string() +
                                 "\"\n" + lines);
        return probe_settings(file);
    };
    EXPECT_EQ(sharing("").back().subject, "gallery") << "off: nothing to say";
    const Finding house = sharing("public_url = \"https://museum.org/pots\"\n").back();
    EXPECT_EQ(house.verdict, Verdict::kGood) << house.found;
    EXPECT_NE(house.found.find("https://museum.org/pots"), std::string::npos);

    const test::HeldPort held;
    const std::string port = std::to_string(held.number());
    const auto listening = listen_at("127.0.0.1", held.number());
    ASSERT_TRUE(listening) << listening.error().message;
    const Finding good = sharing("listen = \"lo\"\nport = " + port + "\n").back();
    EXPECT_EQ(good.verdict, Verdict::kGood) << good.found;
    EXPECT_TRUE(good.found.ends_with("127.0.0.1, port " + port + ", answers")) << good.found;
    ::close(*listening);
    const Finding silent = sharing("listen = \"127.0.0.1\"\nport = " + port + "\n").back();
    EXPECT_EQ(silent.verdict, Verdict::kLacking);
    EXPECT_EQ(silent.found, "no answer from 127.0.0.1, port " + port);
    EXPECT_NE(silent.remedy.find("onggi-share"), std::string::npos);
    const Finding unknown = sharing("listen = \"wlan77\"\n").back();
    EXPECT_EQ(unknown.verdict, Verdict::kLacking);
    EXPECT_NE(unknown.found.find("'wlan77'"), std::string::npos) << unknown.found;

    std::filesystem::permissions(folder.path(),
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    const test::WithoutRootRights bound;
    const std::vector<Finding> locked = probe_settings(file);
    EXPECT_EQ(locked[locked.size() - 2].verdict, Verdict::kLacking);
    EXPECT_NE(locked[locked.size() - 2].found.find("an outbox that can be written"), std::string::npos);
}

TEST(Findings, StateWhetherTheStopKeyIsReadable) {
    const Finding none = probe_stop_keys("/no/such/folder");
    EXPECT_EQ(none.verdict, Finding::Verdict::kNote);
    EXPECT_NE(none.found.find("in the window only"), std::string::npos) << none.found;
    EXPECT_NE(none.found.find("/no/such/folder"), std::string::npos);
}

TEST(SystemProbes, SayThatNoInverseServiceListensWithoutCallingItALack) {
    const test::HeldPort held;
    const std::string place = "127.0.0.1:" + std::to_string(held.number());
    const Finding none = probe_inverse({.port = held.number()});
    EXPECT_EQ(none.verdict, Verdict::kNote);
    EXPECT_EQ(none.found, "Haply Inverse3: looked for at " + place +
                              " while the wheel runs; not found now: nothing listens at " + place +
                              "; its maker's service must be installed and run");
}

TEST(SystemProbes, AlwaysFindTheSimulatedTool) {
    const std::vector<Finding> devices = probe_haptic_devices();
    ASSERT_FALSE(devices.empty());
    EXPECT_NE(devices.front().found.find("simulated"), std::string::npos);
}

}  // namespace
}  // namespace onggi::app

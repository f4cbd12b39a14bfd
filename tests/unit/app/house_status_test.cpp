// The status for a museum's monitoring, from files and a given clock: healthy, silent, ended, crashed; no
// damaged file and no clock may lead to a false report.
#include "game/app/kiosk/health/house_status.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "game/app/kiosk/kiosk_settings.h"
#include "game/app/system/start_log.h"
#include "tests/support/temporary_folder.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;
using State = HouseStatus::State;

constexpr std::int64_t kNoonS = 1'795'608'000;  // 2026-11-25

KioskPulse busy_pulse() {
    return {.screen = "throw",
            .asked_hz = 4000.0,
            .achieved_hz = 3999.5,
            .skipped_periods = 3,
            .late_periods = 12,
            .frame_ms = 16.7,
            .worst_frame_ms = 41.5,
            .frames_shown = 100,
            .haptic_ticks = 4000};
}

StatusNote any_note() {
    return {.at_s = kNoonS,
            .running_s = 3600.5,
            .version = "0.1.0 (abc, 2026-11-25)",
            .pulse = busy_pulse(),
            .celsius = 61.25,
            .resident_mb = 180.5};
}

class AHouse : public testing::Test {
  protected:
    AHouse() {
        config_.gallery.folder = (folder_ / "gallery").string();
        config_.gallery.least_free_mb = 1.0;
        config_.staff.name = "by \"the\" door";
    }
    [[nodiscard]] HouseStatus look(std::int64_t now_s) const {
        auto status = look_at_house(config_, now_s);
        EXPECT_TRUE(status) << status.error().message;
        return status ? *status : HouseStatus{};
    }
    void put_status(std::string_view text) {
        fs::create_directories(status_file(config_.gallery.folder).parent_path());
        test::put_file(status_file(config_.gallery.folder), text);
    }

    test::TemporaryFolder folder_;
    kiosk::Config config_;
};

TEST_F(AHouse, HasNeverBeenStartedWithoutFiles) {
    const HouseStatus status = look(kNoonS);
    EXPECT_EQ(status.state, State::kNeverStarted);
    EXPECT_FALSE(status.is_well());
    EXPECT_FALSE(fs::exists(config_.gallery.folder)) << "who only looks makes no folders";
}

TEST_F(AHouse, IsWellFromOneHeartbeatToTheNextAndSilentAfterwards) {
    KioskHeartbeat heart(config_);
    ASSERT_TRUE(heart.beat(busy_pulse(), kNoonS));
    for (const std::int64_t later_s : {std::int64_t{0}, std::int64_t{61}, HouseStatus::kSilentAfterS}) {
        EXPECT_EQ(look(kNoonS + later_s).state, State::kRunning) << later_s;
        EXPECT_TRUE(look(kNoonS + later_s).is_well()) << later_s;
    }
    const HouseStatus silent = look(kNoonS + HouseStatus::kSilentAfterS + 1);
    EXPECT_EQ(silent.state, State::kSilent);
    EXPECT_EQ(silent.why_not_well.front(), "no heartbeat for 151 s");
    ASSERT_TRUE(heart.end(kNoonS + 400));
    EXPECT_EQ(look(kNoonS + 401).state, State::kEnded);
}

TEST_F(AHouse, IsSilentWhenTheClockWasPutBackAndWellWithTheNextHeartbeat) {
    KioskHeartbeat heart(config_);
    ASSERT_TRUE(heart.beat(busy_pulse(), kNoonS));
    EXPECT_EQ(look(60).state, State::kSilent) << "1970, and no network yet";
    KioskPulse next = busy_pulse();
    next.frames_shown += 3600;
    next.haptic_ticks += 1;
    ASSERT_TRUE(heart.beat(next, 61));
    EXPECT_TRUE(look(62).is_well());
    constexpr std::int64_t kMostOf32Bits = 2'147'483'647;
    next.frames_shown += 1;
    next.haptic_ticks += 1;
    ASSERT_TRUE(heart.beat(next, kMostOf32Bits + 10));
    EXPECT_TRUE(look(kMostOf32Bits + 11).is_well());
    EXPECT_EQ(nlohmann::json::parse(json_of(look(kMostOf32Bits + 11))).at("heartbeat").at("at"),
              "2038-01-19T03:14:17Z");
}

TEST_F(AHouse, SeesAPictureOrALoopThatStandsStill) {
    KioskHeartbeat heart(config_);
    ASSERT_TRUE(heart.beat(busy_pulse(), kNoonS));
    KioskPulse stuck = busy_pulse();
    stuck.haptic_ticks += 1;
    ASSERT_TRUE(heart.beat(stuck, kNoonS + 60));
    EXPECT_EQ(look(kNoonS + 61).why_not_well, std::vector<std::string>{"the picture hangs"});
    stuck.frames_shown += 1;
    ASSERT_TRUE(heart.beat(stuck, kNoonS + 120));
    EXPECT_EQ(look(kNoonS + 121).why_not_well, std::vector<std::string>{"the haptic loop hangs"});
}

TEST_F(AHouse, TellsOfFaultsSafeModeAndAFullDisk) {
    KioskPulse pulse = busy_pulse();
    pulse.fault = "the device is gone";
    pulse.is_safe_mode = true;
    config_.gallery.least_free_mb = 1e9;
    ASSERT_TRUE(KioskHeartbeat(config_).beat(pulse, kNoonS));
    const HouseStatus status = look(kNoonS);
    ASSERT_EQ(status.why_not_well.size(), 3U);
    EXPECT_EQ(status.why_not_well[0], "no force: the device is gone");
    EXPECT_TRUE(status.why_not_well[2].starts_with("no pot is kept"));
}

TEST_F(AHouse, KnowsAFallFromAnEnd) {
    StartKeeper starts(state_folder(config_.gallery.folder));
    std::vector<std::string> remarks;
    static_cast<void>(starts.begin_now(remarks));
    KioskHeartbeat heart(config_);
    ASSERT_TRUE(heart.beat(busy_pulse(), kNoonS));
    ASSERT_TRUE(heart.end(kNoonS + 1));
    EXPECT_EQ(look(kNoonS + 2).state, State::kFell);
    ASSERT_TRUE(starts.end_now());
    EXPECT_EQ(look(kNoonS + 2).state, State::kEnded);
}

TEST_F(AHouse, IsToldByASupervisorThatTheProgramDied) {
    ASSERT_TRUE(KioskHeartbeat(config_).end_after_fall(kNoonS)) << "it had not begun";
    EXPECT_EQ(look(kNoonS).state, State::kNeverStarted);
    StartKeeper starts(state_folder(config_.gallery.folder));
    std::vector<std::string> remarks;
    static_cast<void>(starts.begin_now(remarks));
    ASSERT_TRUE(KioskHeartbeat(config_).beat(busy_pulse(), kNoonS));
    ASSERT_TRUE(KioskHeartbeat(config_).end_after_fall(kNoonS + 1));
    EXPECT_EQ(look(kNoonS + 2).state, State::kFell) << "at once, not when the next heartbeat is late";
    EXPECT_EQ(look(kNoonS + 2).note->at_s, kNoonS + 1);
    ASSERT_TRUE(KioskHeartbeat(config_).end_after_fall(kNoonS + 9));
    EXPECT_EQ(look(kNoonS + 9).note->at_s, kNoonS + 1) << "it was said before";
}

TEST_F(AHouse, CountsTodayAndNamesTheNewestFaults) {
    const fs::path statistics = statistics_folder(config_);
    ASSERT_TRUE(note_visit(statistics, {.dwell_s = 300, .thrown = true, .kept = 2}, kNoonS));
    ASSERT_TRUE(note_visit(statistics, {.dwell_s = 100}, kNoonS + 60));
    ASSERT_TRUE(note_visit(statistics, {.dwell_s = 900, .kept = 1}, kNoonS - 86'400));
    const fs::path faults = faults_folder(config_.gallery.folder);
    fs::create_directories(faults);
    const auto now = fs::file_time_type::clock::now();
    for (int number = 1; number <= 7; ++number) {
        const fs::path file = faults / ("fault-" + std::to_string(number) + ".onggi");
        test::put_file(file, "x");
        fs::last_write_time(file, now - std::chrono::hours(number));
    }
    test::put_file(faults / "notes.txt", "x");
    fs::create_directories(fs::path(config_.gallery.folder) / "2026-11-25" / "pot-001");
    const auto json = nlohmann::json::parse(json_of(look(kNoonS + 100)));
    EXPECT_EQ(json.at("name"), "by \"the\" door");
    EXPECT_EQ(json.at("pots"), 1);
    EXPECT_EQ(json.at("today").at("visits"), 2);
    EXPECT_EQ(json.at("today").at("kept"), 2);
    EXPECT_EQ(json.at("today").at("thrown"), 1);
    EXPECT_EQ(json.at("today").at("mean_dwell_s"), 200.0);
    ASSERT_EQ(json.at("faults").size(), HouseStatus::kMostFaults);
    EXPECT_EQ(json.at("faults").at(0).at("session"), (faults / "fault-1.onggi").string());
}

TEST_F(AHouse, SaysOneFactALine) {
    ASSERT_TRUE(KioskHeartbeat(config_).beat(busy_pulse(), kNoonS));
    std::istringstream lines(lines_of(look(kNoonS + 5)));
    const std::regex a_fact("[a-z]+ +[^ ].*");
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count)
        EXPECT_TRUE(std::regex_match(line, a_fact)) << line;
    EXPECT_GE(count, 9);
}

// https://prometheus.io/docs/instrumenting/exposition_formats/: comments, or a name, labels and a number.
TEST_F(AHouse, WritesMetricsThatPrometheusReadsAndAnotherUserMay) {
    config_.staff.metrics_folder = (folder_ / "metrics").string();
    fs::create_directories(config_.staff.metrics_folder);
    const mode_t before = ::umask(0077);
    KioskHeartbeat heart(config_);
    ASSERT_TRUE(heart.beat(busy_pulse(), kNoonS));
    ::umask(before);
    const fs::path file = folder_ / "metrics/onggi.prom";
    struct stat status {};
    ASSERT_EQ(::stat(file.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777U, 0644U);
    const std::string text = test::content_of(file);
    std::istringstream lines(text);
    const std::regex comment("# (HELP onggi_[a-z_]+ .+|TYPE onggi_[a-z_]+ (gauge|counter))");
    const std::regex sample(
        R"(onggi_[a-z_]+(\{[a-z]+="([^"\\]|\\.)*"(,[a-z]+="([^"\\]|\\.)*")*\})? [-+0-9.e]+)");
    int samples = 0;
    for (std::string line; std::getline(lines, line);) {
        EXPECT_TRUE(std::regex_match(line, comment) || std::regex_match(line, sample)) << line;
        samples += line.starts_with("onggi_") ? 1 : 0;
    }
    EXPECT_GE(samples, 20);
    EXPECT_NE(text.find(R"(onggi_info{name="by \"the\" door",version=")"), std::string::npos);
    EXPECT_NE(text.find("onggi_up 1\n"), std::string::npos);
    ASSERT_TRUE(heart.end(kNoonS + 1));
    EXPECT_NE(test::content_of(file).find("onggi_up 0\n"), std::string::npos);
}

TEST_F(AHouse, ReportsAFailedWriteOnceAndWritesTheOtherFiles) {
    config_.staff.metrics_folder = (folder_ / "nowhere").string();
    KioskHeartbeat heart(config_);
    EXPECT_FALSE(heart.beat(busy_pulse(), kNoonS));
    EXPECT_TRUE(heart.beat(busy_pulse(), kNoonS + 60)) << "it was told";
    EXPECT_EQ(look(kNoonS + 61).note->at_s, kNoonS + 60);
}

TEST(StatusNote, ComesBackAsItWas) {
    StatusNote note = any_note();
    auto read = read_status_note(text_of(note), "status.json");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(*read, note);
    note.celsius.reset();
    note.has_ended = true;
    read = read_status_note(text_of(note), "status.json");
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, note);
}

TEST_F(AHouse, RejectsADamagedHeartbeatInOneLine) {
    const std::string whole = text_of(any_note());
    for (std::size_t size = 0; size < whole.size() - 2; size += 7) {
        put_status(whole.substr(0, size));
        const auto status = look_at_house(config_, kNoonS);
        ASSERT_FALSE(status) << size;
        EXPECT_EQ(status.error().kind, ErrorKind::kBadInput);
        EXPECT_EQ(status.error().message.find('\n'), std::string::npos) << status.error().message;
    }
    auto later = nlohmann::json::parse(whole);
    later["format"] = 2;
    put_status(later.dump());
    EXPECT_NE(look_at_house(config_, kNoonS).error().message.find("of format 1, found 2"), std::string::npos);
    later["format"] = 1;
    later["at_s"] = -5;
    put_status(later.dump());
    EXPECT_FALSE(look_at_house(config_, kNoonS));
}

}  // namespace
}  // namespace onggi::app

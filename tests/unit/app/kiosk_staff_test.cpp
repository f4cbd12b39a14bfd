// The staff's panel: health, faults, and results of tests.
#include "game/app/kiosk/staff/kiosk_staff.h"

#include <gtest/gtest.h>

namespace onggi::app {
namespace {

using kiosk::StaffPage;
using screens::StaffLine;
using Stage = haptic::ForceTestReport::Stage;

Health well() {
    return {.asked_hz = 4000.0,
            .achieved_hz = 3998.0,
            .frame_ms = 16.7,
            .worst_frame_ms = 21.0,
            .device_ms = 9.8,
            .parts = {{.name = "overlay's pictures", .ms = 0.01},
                      {.name = "lathe", .ms = 6.1},
                      {.name = "overlay", .ms = 1.2}},
            .quality = "one software core",
            .celsius = 54.0,
            .free_mb = 10'000.0,
            .least_free_mb = 200.0,
            .running_s = 3.0 * 3600.0 + 120.0,
            .text_degrees = 0.76,
            .distance_mm = 600.0,
            .sound = "Built-in Audio"};
}

StaffLine line(const Health& health, const std::string& name, StaffPage page = StaffPage::kHealth) {
    for (const StaffLine& one : staff_lines(health, page)) {
        if (one.name == name) return one;
    }
    ADD_FAILURE() << "no line " << name;
    return {};
}

TEST(StaffLines, SayOkWhereAllIsWell) {
    for (const StaffLine& one : staff_lines(well(), StaffPage::kHealth))
        EXPECT_TRUE(one.status == "ok" || one.status.empty()) << one.name << ' ' << one.value;
    EXPECT_EQ(line(well(), "Force tick").value, "3998 of 4000 Hz");
    EXPECT_EQ(line(well(), "Drawing").value, "9.8 ms: lathe 6.1, overlay 1.2");
    EXPECT_EQ(line(well(), "Temperature").value, "54 \u00b0C");
    EXPECT_EQ(line(well(), "Running").value, "3 h 2 min, started 0 times today");
}

// With the CPU backend, most drawing happens before the device's part.
TEST(StaffLines, CountTheHostsDrawing) {
    Health health = well();
    health.device_ms = 0.4;
    health.parts = {{.name = "room", .ms = 0.52, .is_on_host = true},
                    {.name = "hands and clay", .ms = 1.33, .is_on_host = true},
                    {.name = "overlay", .ms = 0.3}};
    EXPECT_EQ(line(health, "Drawing").value, "2.2 ms: room 0.5, hands and clay 1.3, overlay 0.3");
}

TEST(StaffLines, WarnOfEachThingThatIsNot) {
    const auto status = [](const std::string& name, const auto& spoil) {
        Health health = well();
        spoil(health);
        return line(health, name).status;
    };
    EXPECT_EQ(status("Force tick", [](Health& h) { h.achieved_hz = 3600.0; }), "warn");
    EXPECT_EQ(status("Missed ticks", [](Health& h) { h.skipped_periods = 1; }), "warn");
    EXPECT_EQ(status("Late ticks", [](Health& h) { h.late_periods = 1; }), "warn");
    EXPECT_EQ(status("Force", [](Health& h) { h.fault = "the force was stopped"; }), "fault");
    EXPECT_EQ(status("Frame", [](Health& h) { h.frame_ms = 40.0; }), "warn");
    EXPECT_EQ(status("Temperature", [](Health& h) { h.celsius = 93.0; }), "warn");
    EXPECT_EQ(status("Disk free", [](Health& h) { h.free_mb = 150.0; }), "fault");
    EXPECT_EQ(status("Smallest text", [](Health& h) { h.text_degrees = 0.5; }), "warn");
    EXPECT_EQ(status("Sound", [](Health& h) { h.sound.clear(); }), "warn");
}

TEST(StaffLines, ReplaceUnknownNumbersByWords) {
    Health health = well();
    health.celsius.reset();
    health.device_ms = 0.0;
    health.achieved_hz = 0.0;
    EXPECT_EQ(line(health, "Temperature").value, "not measured here");
    EXPECT_EQ(line(health, "Temperature").status, "");
    EXPECT_EQ(line(health, "Drawing").value, "this device does not measure it");
    EXPECT_EQ(line(health, "Force tick").value, "4000 Hz asked for");
}

TEST(StaffLines, CountVisitsByTheHour) {
    Health health = well();
    health.use.hours[9] = {.breaks = 4, .visits = 3, .thrown = 2, .kept = 1, .dwell_s = 270};
    health.use.hours[14] = {.breaks = 1};
    const auto lines = staff_lines(health, StaffPage::kVisits);
    ASSERT_EQ(lines.size(), 3U) << "hours without visitors take no line";
    EXPECT_EQ(lines[0].value, "5 begun, 3 ended, 2 thrown, 1 kept, 1 min 30 s each");
    EXPECT_EQ(lines[1].name, "09\u201310 h");
    EXPECT_EQ(lines[1].value, "4 begun, 3 ended, 2 thrown, 1 kept, 1 min 30 s each");
    EXPECT_EQ(lines[2].value, "1 begun, 0 ended, 0 thrown, 0 kept");
}

TEST(StaffLines, GiveEachPotItsOwnNumberForTheDeleteKey) {
    Health health = well();
    EXPECT_EQ(line(health, "Pots", StaffPage::kGallery).pot, -1) << "nothing to delete";
    health.pots = {{7, "2026-11-22/pot-003"}, {2, "2026-11-22/pot-002"}};
    const auto lines = staff_lines(health, StaffPage::kGallery);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[0].pot, 7);
    EXPECT_EQ(lines[0].value, "2026-11-22/pot-003");
    EXPECT_EQ(lines[1].pot, 2);
}

TEST(StaffLines, SayWhichPotsPhonesMayFetchAndGiveThemAKeyToWithdraw) {
    Health health = well();
    health.pots = {{7, "2026-11-22/pot-003"}, {2, "2026-11-22/pot-002"}};
    health.shared = {{2, {"2026-11-22/pot-002", "18:00"}}, {9, {"2026-11-22/pot-001", "18:00"}}};
    const auto lines = staff_lines(health, StaffPage::kGallery);
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines[0].code, -1) << "it is not shared";
    EXPECT_EQ(lines[1].pot, 2);
    EXPECT_EQ(lines[1].code, 2);
    EXPECT_EQ(lines[1].name, "Shared until 18:00");
    EXPECT_EQ(lines[2].pot, -1) << "the gallery has it no more";
    EXPECT_EQ(lines[2].code, 9);
    EXPECT_EQ(lines[2].value, "2026-11-22/pot-001, no longer here");
}

TEST(StaffLines, CountThePotsBeyondThoseListed) {
    Health health = well();
    health.pots = {{0, "2026-11-22/pot-003"}};
    health.pots_beyond = 9000;
    health.shared = {{9, {"2026-11-20/pot-001", "18:00"}}};
    const auto lines = staff_lines(health, StaffPage::kGallery);
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines[1].value, "9000 more on the disk");
    EXPECT_EQ(lines[2].value, "2026-11-20/pot-001, not among these") << "not checked yet";
    EXPECT_EQ(lines[2].code, 9);
}

TEST(StaffLines, ListEachDeviceWithItsAbilityOrRefusal) {
    Health health = well();
    EXPECT_EQ(line(health, "Plugged in", StaffPage::kDevices).value, "none");
    health.holder = "SpaceMouse Compact";
    health.devices = {
        {.name = "SpaceMouse Compact", .ability = "moves the tool", .works = true, .why_not = ""},
        {.name = "DualSense", .ability = "moves the tool", .works = false, .why_not = "no permission"}};
    EXPECT_EQ(line(health, "Has the tool", StaffPage::kDevices).value, "SpaceMouse Compact");
    EXPECT_EQ(line(health, "SpaceMouse Compact", StaffPage::kDevices).status, "ok");
    EXPECT_EQ(line(health, "DualSense", StaffPage::kDevices).value, "no permission");
    EXPECT_EQ(line(health, "DualSense", StaffPage::kDevices).status, "warn");
    health.restless = {"a worn pad"};
    EXPECT_EQ(line(health, "a worn pad", StaffPage::kDevices).status, "warn");
}

TEST(ForceTestWords, DescribeTheHandsResponse) {
    EXPECT_EQ(force_test_words({}, "hand"), "");
    EXPECT_EQ(
        force_test_words({.stage = Stage::kDone, .given_n = {0.6, 0.59, 0.6}, .moved_mm = {3.0, 2.9, 3.1}},
                         "SpaceMouse"),
        "Force: ok. SpaceMouse: 0.59 N of 0.60, moved 2.9 up, 3.0 right, 3.1 mm near");
    const auto says = [](const haptic::ForceTestReport& report, std::string_view part) {
        return force_test_words(report, "hand").find(part) != std::string::npos;
    };
    EXPECT_TRUE(says({.stage = Stage::kDone, .given_n = {0.6, 0.6, 0.6}}, "given, but nothing moved"));
    EXPECT_TRUE(says({.stage = Stage::kDone, .given_n = {0.6, 0.0, 0.6}, .moved_mm = {3.0, 0.0, 3.0}},
                     "less than asked for"));
    EXPECT_TRUE(says({.stage = Stage::kNobody}, "feels no hand"));
    EXPECT_TRUE(says({.stage = Stage::kBroken}, "interrupted"));
}

}  // namespace
}  // namespace onggi::app

#include "tests/unit/screens/sample_staff.h"

#include <utility>

namespace onggi::screens {

void add_staff_views(const View& base, std::vector<SampleView>& all) {
    using kiosk::StaffPage;
    const auto add = [&](const std::string& name, StaffPage page, const auto& change) {
        View view = base;
        view.state.panel = kiosk::Panel::kStaff;
        view.state.staff.page = page;
        view.staff_title = "Wheel 2, by the window";
        change(view);
        all.push_back({name, std::make_shared<const View>(std::move(view))});
    };
    // The longest that each line may become.
    const std::vector<StaffLine> health{
        {"Force tick", "3,994 of 4,000 Hz", "ok", -1},
        {"Missed ticks", "1204513", "warn", -1},
        {"Late ticks", "0", "ok", -1},
        {"Force", "the tool's position was not a finite number", "fault", -1},
        {"Frame", "16.7 ms, at most 118 in 10 s", "ok", -1},
        {"Drawing",
         "12.4 ms: overlay's pictures 0.3, still life 4.1, lathe 5.0, hands and tools 1.2, overlay 1.8", "",
         -1},
        {"Picture", "two or more software cores", "", -1},
        {"Temperature", "not measured here", "", -1},
        {"Disk free", "152343 MB, 200 needed", "ok", -1},
        {"Running", "214 h 32 min, started 12 times today", "", -1},
        {"Smallest text", "0.76\u00b0 at 600 mm", "ok", -1},
        {"Sound", "none: expected a sound device, found none that opens", "warn", -1}};
    add("staff-health", StaffPage::kHealth, [&](View& view) {
        view.staff_lines = health;
        for (int i = 0; i < 100; ++i) {
            view.staff_plot.frame_ms.push_back(i % 37 == 5 ? 46.0F : 17.0F + static_cast<float>(i % 3));
            view.staff_plot.device_ms.push_back(9.0F + static_cast<float>(i % 5));
        }
    });
    add("staff-health-on", StaffPage::kHealth, [&](View& view) {
        view.staff_lines = health;
        view.state.staff.first_line = 6;
        view.staff_notice =
            "Force: ok. 3Dconnexion SpaceMouse Compact: 0.59 N of 0.60, moved 3.0 up, 3.0 right, 2.9 mm near";
    });
    add("staff-visits", StaffPage::kVisits, [](View& view) {
        view.staff_lines = {{"Today", "142 begun, 131 ended, 104 thrown, 71 kept, 2 min 12 s each", "", -1}};
        for (int hour = 9; hour < 19; ++hour)
            view.staff_lines.push_back({std::to_string(hour) + "\u2013" + std::to_string(hour + 1) + " h",
                                        "14 begun, 13 ended, 10 thrown, 7 kept, 2 min 2 s each", "", -1});
    });
    const auto pots = [](View& view) {
        for (int pot = 24; pot > 0; --pot)
            view.staff_lines.push_back({"Pot", "2026-11-22/pot-" + std::to_string(100 + pot), "", pot});
        for (const std::size_t pot : {0U, 2U}) {
            view.staff_lines[pot].name = "Shared until 18:00";
            view.staff_lines[pot].code = view.staff_lines[pot].pot;
        }
    };
    add("staff-gallery", StaffPage::kGallery, pots);
    add("staff-gallery-on", StaffPage::kGallery, [&](View& view) {
        pots(view);
        view.state.staff.first_line = 8;
        view.staff_notice = "Sound: left, right, both, by Built-in Audio Analogue Stereo";
    });
    add("staff-devices", StaffPage::kDevices, [](View& view) {
        view.staff_lines = {
            {"Has the tool", "touch, mouse", "", -1},
            {"Microsoft SideWinder Force Feedback 2", "moves the tool; pushes, 2 axes, 3.0 N", "ok", -1},
            {"VEC Footpedal", "turns the wheel", "ok", -1},
            {"DualSense", "/dev/hidraw4: expected permission to open it, found none", "warn", -1}};
    });
    const auto asks = [&](const std::string& name, kiosk::StaffQuestion question) {
        add(name, StaffPage::kGallery, [&](View& view) {
            view.state.staff.question = question;
            view.staff_pot = "2026-11-22/pot-124";
        });
    };
    asks("staff-asks-delete", kiosk::StaffQuestion::kDeletePot);
    asks("staff-asks-withdraw", kiosk::StaffQuestion::kWithdrawCode);
    asks("staff-asks-restart", kiosk::StaffQuestion::kRestart);
    asks("staff-asks-quit", kiosk::StaffQuestion::kQuit);
}

}  // namespace onggi::screens

// Runs the staff's panel: gathers its data, follows the running tests, and numbers the gallery's pots
// permanently, so that the delete key removes the pot that was shown. Main thread.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "game/app/kiosk/health/kiosk_health.h"
#include "game/app/kiosk/health/kiosk_status.h"
#include "game/app/kiosk/keeping/kiosk_keeper.h"
#include "game/app/kiosk/keeping/kiosk_phone.h"
#include "game/app/kiosk/presentation/kiosk_sound.h"
#include "game/app/kiosk/staff/kiosk_staff.h"
#include "game/app/system/start_log.h"
#include "game/wheel/live_view.h"

namespace onggi::app {

// The desk's collaborators, which must outlive it.
struct DeskParts {
    wheel::LiveView& view;
    haptic::HapticJob& job;
    AttachedDevices& devices;
    KioskKeeper& keeper;
    KioskPhone* phone;  // as in VisitParts
    KioskSound& sound;
    const kiosk::Config& config;
    StartReport start;
    double rate_hz;
};

class StaffDesk {
  public:
    explicit StaffDesk(const DeskParts& parts) : parts_(parts) {}

    // Call it once a frame on every screen. frame_ms is the time since the last frame.
    void see_frame(double now_s, double frame_ms, const haptic::Snapshot& snapshot);
    // The names of devices and controls that do not come to rest.
    void see_restless(const std::vector<std::string>& names) { restless_ = names; }
    // The data for the museum's monitoring: only the program's health.
    [[nodiscard]] KioskPulse pulse(const haptic::Snapshot& snapshot) const;
    void take(const KeeperAnswer::Survey& survey);
    void take(const PhoneAnswer::Survey& survey);
    void test_force();
    void test_sound();
    // Deletes the pot of that number, if it exists.
    void delete_pot(int number);
    // Withdraws the pot's code and keeps the pot.
    void withdraw_code(int number);

    // Adds the panel's content to the view. Lines and plot change at most once a second, so that they are
    // readable.
    void add_to(screens::View& view, const haptic::Snapshot& snapshot);
    // Tells the desk that the panel is closed.
    void leave();

  private:
    [[nodiscard]] Health health(const screens::View& view, const haptic::Snapshot& snapshot) const;
    [[nodiscard]] std::string notice(const haptic::Snapshot& snapshot) const;
    [[nodiscard]] int number_of(const std::string& pot);
    [[nodiscard]] const std::string* name_of(int number) const;

    DeskParts parts_;
    HealthMeter meter_;
    std::vector<std::string> restless_;
    std::optional<double> started_s_;
    double now_s_ = 0.0;
    std::optional<KeeperAnswer::Survey> survey_;
    std::vector<SharedPotNote> shared_;     // of the last survey
    std::vector<std::string> pots_;         // all ever surveyed; a pot's number is its index
    std::map<std::string, int> numbers_;    // from name to index in pots_
    std::optional<kiosk::StaffPage> page_;  // the page of lines_
    std::vector<screens::StaffLine> lines_;
    screens::FramePlot plot_;
    double surveyed_s_ = -1e9;
    bool is_open_ = false;
    enum class Test { kNone, kForce, kSound } test_ = Test::kNone;
};

}  // namespace onggi::app

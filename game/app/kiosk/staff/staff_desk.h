// The staff's panel at work: it gathers what the panel says, follows the tests that were asked for, and knows
// the gallery's pots by numbers that stay, so that what is deleted is what was shown. Main thread.
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

// What the desk asks; all of it outlives the desk.
struct DeskParts {
    wheel::LiveView& view;
    haptic::HapticJob& job;
    AttachedDevices& devices;
    KioskKeeper& keeper;
    KioskPhone* phone;  // as VisitParts has it
    KioskSound& sound;
    const kiosk::Config& config;
    StartReport start;
    double rate_hz;
};

class StaffDesk {
  public:
    explicit StaffDesk(const DeskParts& parts) : parts_(parts) {}

    // Once a frame, whatever is shown. frame_ms: since the frame before.
    void see_frame(double now_s, double frame_ms, const haptic::Snapshot& snapshot);
    // What the house's monitoring is told, of the program's health alone.
    [[nodiscard]] KioskPulse pulse(const haptic::Snapshot& snapshot) const;
    void take(const KeeperAnswer::Survey& survey);
    void take(const PhoneAnswer::Survey& survey);
    void test_force();
    void test_sound();
    // The pot of that number goes; nothing happens where there is none.
    void delete_pot(int number);
    // Its code is over, and the pot stays.
    void withdraw_code(int number);

    // What the panel shows. Lines and plot change once a second at most, so that they can be read.
    void add_to(screens::View& view, const haptic::Snapshot& snapshot);
    // Nobody looks at the panel.
    void leave();

  private:
    [[nodiscard]] Health health(const screens::View& view, const haptic::Snapshot& snapshot) const;
    [[nodiscard]] std::string notice(const haptic::Snapshot& snapshot) const;
    [[nodiscard]] int number_of(const std::string& pot);
    [[nodiscard]] const std::string* name_of(int number) const;

    DeskParts parts_;
    HealthMeter meter_;
    std::optional<double> started_s_;
    double now_s_ = 0.0;
    std::optional<KeeperAnswer::Survey> survey_;
    std::vector<SharedPotNote> shared_;     // as the last survey found them
    std::vector<std::string> pots_;         // all that were ever surveyed; the number is the place
    std::map<std::string, int> numbers_;    // of them
    std::optional<kiosk::StaffPage> page_;  // that lines_ are of
    std::vector<screens::StaffLine> lines_;
    screens::FramePlot plot_;
    double surveyed_s_ = -1e9;
    bool is_open_ = false;
    enum class Test { kNone, kForce, kSound } test_ = Test::kNone;
};

}  // namespace onggi::app

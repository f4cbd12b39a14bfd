// What a visit is made of, and how its parts reach each other. Main thread.
#pragma once

#include <functional>
#include <string>

#include "engine/haptics/simulated_device.h"
#include "game/app/devices/hand_devices.h"
#include "game/app/kiosk/keeping/kiosk_keeper.h"
#include "game/app/kiosk/keeping/kiosk_phone.h"
#include "game/app/kiosk/kiosk_settings.h"
#include "game/app/kiosk/presentation/demonstrations.h"
#include "game/app/kiosk/presentation/kiosk_sound.h"
#include "game/app/kiosk/staff/kiosk_staff.h"
#include "game/app/system/start_log.h"
#include "game/haptic/job.h"
#include "game/kiosk/events.h"
#include "game/wheel/live_view.h"

namespace onggi::app {

// Volume goes in steps.
constexpr double kLoudestStep = kiosk::kMostVolume;

// What a visit needs; all of it outlives the visit.
struct VisitParts {
    wheel::LiveView& view;
    haptic::HapticJob& job;
    haptics::SimulatedDevice& hand;
    HandDevices& devices;
    KioskKeeper& keeper;
    KioskPhone* phone = nullptr;  // null: nothing is taken home by phone
    KioskSound& sound;
    const KioskSettings& settings;
    const Show& show;
    StartReport start{};                                      // what the staff is told of falls before
    double rate_hz;                                           // of the haptic job
    std::function<int()> minute_of_day = app::minute_of_day;  // local time, for the opening hours
};

// A frame's moment. The snapshot is the only one that is looked at in it.
struct VisitMoment {
    double now_s;  // of the monotonic clock
    double dt_s;   // since the frame before
    const haptic::Snapshot& snapshot;
};

// Where a visit stands, and how it is taken on: what its parts know of it.
class VisitFlow {
  public:
    [[nodiscard]] virtual const kiosk::State& state() const = 0;
    // Takes the state on and applies the effects before it returns. Precondition: a frame is being made, to
    // whose moment the effects are applied.
    virtual void dispatch(const kiosk::Event& event) = 0;
    // A line for the log; warn(): of what went wrong and is borne.
    virtual void say(const std::string& line) = 0;
    virtual void warn(const std::string& line) = 0;

  protected:
    VisitFlow() = default;
    VisitFlow(const VisitFlow&) = default;
    VisitFlow& operator=(const VisitFlow&) = default;
    ~VisitFlow() = default;
};

// On which side the hand comes to the clay: +1 right, -1 left.
[[nodiscard]] inline double side_of(const kiosk::State& state) {
    return state.comfort.left_hand ? -1.0 : 1.0;
}

}  // namespace onggi::app

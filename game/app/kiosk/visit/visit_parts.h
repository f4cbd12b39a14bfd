// What a visit is made of, and how its parts reach each other. Main thread.
#pragma once

#include <functional>
#include <string>

#include "game/app/devices/attached_devices.h"
#include "game/app/kiosk/keeping/kiosk_keeper.h"
#include "game/app/kiosk/keeping/kiosk_phone.h"
#include "game/app/kiosk/kiosk_settings.h"
#include "game/app/kiosk/presentation/demonstrations.h"
#include "game/app/kiosk/presentation/kiosk_sound.h"
#include "game/app/kiosk/staff/kiosk_staff.h"
#include "game/app/system/start_log.h"
#include "game/haptic/job.h"
#include "game/haptic/simulated_device.h"
#include "game/visit/flow/visit_flow.h"
#include "game/wheel/live_view.h"

namespace onggi::app {

// Volume goes in steps.
constexpr double kLoudestStep = kiosk::kMostVolume;

// What a visit needs; all of it outlives the visit.
struct VisitParts {
    wheel::LiveView& view;
    haptic::HapticJob& job;
    haptic::SimulatedDevice& pointer;  // mouse and touch
    AttachedDevices& devices;
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

using visit::VisitFlow;

// On which side the hand comes to the clay: +1 right, -1 left.
[[nodiscard]] inline double side_of(const kiosk::State& state) {
    return state.comfort.left_hand ? -1.0 : 1.0;
}

}  // namespace onggi::app

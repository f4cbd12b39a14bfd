// The collaborators of a visit, and the interface between its parts. Main thread.
#pragma once

#include <functional>
#include <string>

#include "game/app/devices/attached_devices.h"
#include "game/app/kiosk/keeping/kiosk_keeper.h"
#include "game/app/kiosk/keeping/kiosk_phone.h"
#include "game/app/kiosk/kiosk_settings.h"
#include "game/app/kiosk/presentation/demonstrations.h"
#include "game/app/kiosk/presentation/kiosk_sound.h"
#include "game/app/kiosk/presentation/kiosk_voice.h"
#include "game/app/kiosk/staff/kiosk_staff.h"
#include "game/app/system/start_log.h"
#include "game/haptic/job.h"
#include "game/haptic/simulated_device.h"
#include "game/visit/flow/visit_flow.h"
#include "game/wheel/live_view.h"

namespace onggi::app {

// The number of volume steps.
constexpr double kLoudestStep = kiosk::kMostVolume;

// The collaborators of a visit, which must outlive it.
struct VisitParts {
    wheel::LiveView& view;
    haptic::HapticJob& job;
    haptic::SimulatedDevice& pointer;  // mouse and touch
    AttachedDevices& devices;
    KioskKeeper& keeper;
    KioskPhone* phone = nullptr;  // null without sharing
    KioskSound& sound;
    KioskVoice* voice = nullptr;  // null: nothing is spoken
    const KioskSettings& settings;
    const Show& show;
    StartReport start{};                                      // earlier crashes, for the staff
    double rate_hz;                                           // of the haptic job
    std::function<int()> minute_of_day = app::minute_of_day;  // local time, for the opening hours
};

// The data of a frame, with the only snapshot that the frame reads.
struct VisitMoment {
    double now_s;   // of the monotonic clock
    double dt_s;    // since the last frame
    double clay_s;  // of the clay since the last frame: less than dt_s where the haptic loop skips periods
    const haptic::Snapshot& snapshot;
};

using visit::VisitFlow;

// The side from which the hand works: +1 right, -1 left.
[[nodiscard]] inline double side_of(const kiosk::State& state) {
    return state.comfort.left_hand ? -1.0 : 1.0;
}

}  // namespace onggi::app

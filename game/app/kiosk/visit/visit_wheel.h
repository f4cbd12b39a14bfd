// The wheel of a visit: the requested clay, the demonstrations of attract mode, the hand, and the events from
// clay and forces. Main thread.
#pragma once

#include <cstdint>
#include <optional>

#include "engine/haptics/safety_chain.h"
#include "game/app/kiosk/finger/kiosk_finger.h"
#include "game/app/kiosk/presentation/kiosk_pot.h"
#include "game/app/kiosk/visit/visit_parts.h"
#include "game/haptic/messages.h"
#include "game/kiosk/state.h"

namespace onggi::app {

// The events of the clay on the wheel: the lesson's progress, warnings, a collapse. Requested clay takes some
// frames to arrive; until then the old clay causes no events, be it the last visitor's or the collapsed one.
// Pure state, no clock. Main thread, once a frame.
struct ClayNews {
    int steps_done = 0;  // of kiosk::kTeachingSteps
    bool is_solid = false;
    int thick_mm = 0;  // of a wall that another pull would do good; 0: it is thin enough
    kiosk::Warning warning = kiosk::Warning::kNone;
    std::optional<kiosk::Warning> gave_way{};  // the cause; reported once
};

class KioskClay {
  public:
    // Expects a requested lump, `run` as of Snapshot::run.
    void expect_lump(std::uint64_t run);
    // Expects a requested state of that lump, for example an interrupted pot's. `now` is the present
    // snapshot.
    void expect_state(const haptic::Snapshot& now);
    // Stops waiting for requested clay: the clay on the wheel stays.
    void expect_nothing() { puts_before_.reset(); }

    // Returns nothing until the requested clay has arrived. `before`: the present warning.
    [[nodiscard]] std::optional<ClayNews> look(const haptic::Snapshot& snapshot, kiosk::Warning before);
    // The tick at which the collapse began; 0 while the clay stands.
    [[nodiscard]] std::uint64_t began_to_fail_tick() const { return failing_tick_; }

  private:
    [[nodiscard]] bool is_there(const haptic::Snapshot& snapshot);

    Lesson lesson_;
    std::uint64_t run_ = 0;
    std::optional<std::uint64_t> puts_before_;  // a number of Snapshot::states_put
    std::uint64_t failing_tick_ = 0;
    bool has_said_ = false;
    // The height before it began to fail.
    double standing_height_mm_ = 0.0;
    double standing_width_mm_ = 0.0;
};

// The kiosk's response to a latched fault of the safety chain. The force is off but the clay still works, so
// the visitor is informed and may continue. Only an invalid clay state ends a visit. Pure state, no clock.
// Main thread, once a frame. s.
class KioskFault {
  public:
    // The time before a fault is reset automatically: a transient fault needs no staff.
    static constexpr double kRestS = 5.0;

    struct Advice {
        bool force_rests = false;  // inform the visitor, who may go on
        bool wheel_rests = false;  // the clay itself is at fault: throwing is not possible
        bool take_back = false;    // reset the fault now
    };
    // now_s ascends. A stop by a person is never reset by time, only by taking new clay.
    [[nodiscard]] Advice look(haptics::Fault fault, double now_s);

  private:
    haptics::Fault last_ = haptics::Fault::kNone;
    double tried_s_ = 0.0;  // time of the last attempt, or the start of the fault
};

class VisitWheel {
  public:
    // Glaze and decoration must outlive it.
    VisitWheel(const VisitParts& parts, VisitFlow& flow) : parts_(parts), flow_(flow) {}

    void put_fresh_clay();
    // Resets a fault, and a person's stop too if requested by a person.
    void rearm_force();
    // Attract mode: starts the next recording on its own clay.
    void begin_show(double now_s);
    // Ends the demonstrations: the clay is a visitor's.
    void end_shows() { demo_runs_ = false; }

    // Dispatches the events of clay and forces.
    void take_clay(const haptic::Snapshot& snapshot, bool holder_lives);
    void take_fault(const VisitMoment& moment);
    // Moves the hand and its tool.
    void move_hand(const VisitMoment& moment);

    [[nodiscard]] KioskFinger& finger() { return finger_; }
    [[nodiscard]] const KioskFinger& finger() const { return finger_; }
    // Whether the requested clay is on the wheel, as of the last take_clay() on the throwing screen.
    [[nodiscard]] bool clay_is_there() const { return clay_is_there_; }
    [[nodiscard]] KioskClay& clay() { return clay_; }
    [[nodiscard]] bool shows() const { return demo_runs_; }
    // The run of the last requested lump, see Snapshot::run.
    [[nodiscard]] std::uint64_t run() const { return run_; }
    // The number of requested lumps.
    [[nodiscard]] std::uint64_t lumps_asked() const { return lumps_asked_; }

  private:
    // Returns false if there is nothing to show.
    bool play_show(const VisitMoment& moment);
    void soak(const VisitMoment& moment);

    const VisitParts& parts_;
    VisitFlow& flow_;
    KioskFinger finger_;
    KioskClay clay_;
    KioskFault fault_;
    bool clay_is_there_ = false;
    bool demo_runs_ = true;
    double demo_since_s_ = 0.0;
    std::optional<std::size_t> shown_;  // index of the recording on the wheel, or 0 for the gesture
    std::size_t shows_begun_ = 0;
    std::uint64_t run_ = 0;
    std::uint64_t lumps_asked_ = 0;
    double soaked_rad_ = 0.0;  // the wall's rotation under the sponge since it last took water
};

}  // namespace onggi::app

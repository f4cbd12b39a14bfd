// The wheel under a visit: the clay that was asked for, the demonstrations of attract, the hand that works
// it, and what clay and force tell the visit. Main thread.
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

// What the clay on the wheel tells a visit: how far the lesson has come, what it warns of, that it gave way.
// New clay, or an earlier state of it, is on its way for some frames: until it is there, what is on the wheel
// is the last visitor's, or what sank, and tells nothing. Pure state, no clock. Main thread, once a frame.
struct ClayNews {
    int steps_done = 0;  // of kiosk::kTeachingSteps
    kiosk::Warning warning = kiosk::Warning::kNone;
    std::optional<kiosk::Warning> gave_way{};  // by what; said once
};

class KioskClay {
  public:
    // Another lump was asked for: that run, as Snapshot::run counts.
    void expect_lump(std::uint64_t run);
    // A state of that lump was asked for, an interrupted pot's among them. `now` is what is on the wheel.
    void expect_state(const haptic::Snapshot& now);
    // It does not come: what is on the wheel stays.
    void expect_nothing() { puts_before_.reset(); }

    // Nothing while what was asked for is on its way. `before`: what is being warned of.
    [[nodiscard]] std::optional<ClayNews> look(const haptic::Snapshot& snapshot, kiosk::Warning before);
    // The tick at which the clay that gave way began to; 0 while it stands.
    [[nodiscard]] std::uint64_t began_to_fail_tick() const { return failing_tick_; }

  private:
    [[nodiscard]] bool is_there(const haptic::Snapshot& snapshot);

    Lesson lesson_;
    std::uint64_t run_ = 0;
    std::optional<std::uint64_t> puts_before_;  // as Snapshot::states_put counts
    std::uint64_t failing_tick_ = 0;
    bool has_said_ = false;
    // Before it began to fail.
    double standing_height_mm_ = 0.0;
    double standing_width_mm_ = 0.0;
};

// What a latched fault of the safety chain means to a visitor. The force is off; the clay goes on. So whoever
// throws, by mouse, touch or anything else, goes on too, and is told; only a clay that has lost its senses
// ends a visit. Pure state, no clock. Main thread, once a frame. s.
class KioskFault {
  public:
    // How long the wheel waits before it takes a fault back by itself: what passed by needs no staff.
    static constexpr double kRestS = 5.0;

    struct Advice {
        bool force_rests = false;  // say so, and let the visitor go on
        bool wheel_rests = false;  // the clay itself is at fault: nobody can throw
        bool take_back = false;    // try again now
    };
    // now_s ascends. A person's stop is never taken back by a clock, but by whoever takes new clay.
    [[nodiscard]] Advice look(haptics::Fault fault, double now_s);

  private:
    haptics::Fault last_ = haptics::Fault::kNone;
    double tried_s_ = 0.0;  // or since when there is one
};

class VisitWheel {
  public:
    // Both outlive it.
    VisitWheel(const VisitParts& parts, VisitFlow& flow) : parts_(parts), flow_(flow) {}

    void put_fresh_clay();
    // Takes a fault back, and where a person wishes it a person's stop too.
    void rearm_force();
    // Attract: the next recording, on clay of its own.
    void begin_show(double now_s);
    // The clay is a visitor's.
    void end_shows() { demo_runs_ = false; }

    // What clay and force tell the visit.
    void take_clay(const haptic::Snapshot& snapshot, bool holder_lives);
    void take_fault(const VisitMoment& moment);
    // Where the hand and its tool go next.
    void move_hand(const VisitMoment& moment);

    [[nodiscard]] KioskFinger& finger() { return finger_; }
    [[nodiscard]] const KioskFinger& finger() const { return finger_; }
    // What is on the wheel is what was asked for, as far as the last take_clay() on the throwing screen knew.
    [[nodiscard]] bool clay_is_there() const { return clay_is_there_; }
    [[nodiscard]] KioskClay& clay() { return clay_; }
    [[nodiscard]] bool shows() const { return demo_runs_; }
    // Of the lump that was asked for last, as Snapshot::run counts.
    [[nodiscard]] std::uint64_t run() const { return run_; }
    // How often one was asked for.
    [[nodiscard]] std::uint64_t lumps_asked() const { return lumps_asked_; }

  private:
    // False: there is nothing to show.
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
    std::optional<std::size_t> shown_;  // the recording, or 0 for the gesture, that is on the wheel
    std::size_t shows_begun_ = 0;
    std::uint64_t run_ = 0;
    std::uint64_t lumps_asked_ = 0;
    double soaked_rad_ = 0.0;  // that the wall has turned under the sponge since it last took water
};

}  // namespace onggi::app

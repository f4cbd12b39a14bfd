// The wheel under a visit: the clay that was asked for, the demonstrations of attract, the hand that works
// it, and what clay and force tell the visit. Main thread.
#pragma once

#include <cstdint>
#include <optional>

#include "game/app/kiosk/hand/kiosk_hand.h"
#include "game/app/kiosk/visit/kiosk_clay.h"
#include "game/app/kiosk/visit/kiosk_fault.h"
#include "game/app/kiosk/visit/visit_parts.h"

namespace onggi::app {

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
    void take_clay(const haptic::Snapshot& snapshot);
    void take_fault(const VisitMoment& moment);
    // Where the hand and its tool go next.
    void move_hand(const VisitMoment& moment);

    [[nodiscard]] KioskHand& hand() { return hand_; }
    [[nodiscard]] const KioskHand& hand() const { return hand_; }
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
    KioskHand hand_;
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

// The hand's input from a device and the orders to it: plain values exchanged by the I/O thread and the
// haptic thread through mailboxes. mm, N, s; wheel frame of hand_sample.h, the tool in the plane z = 0 right
// of the wheel: x is the radius, y the height.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "engine/haptics/haptic_device.h"
#include "engine/math/math.h"

namespace onggi::haptics::hid {

// The range of the tool. A device moves it in two axes, radius and height: the pot is round.
struct ToolReach {
    double least_radius_mm = 0.0;
    double most_radius_mm = 150.0;
    double least_height_mm = 0.0;
    double most_height_mm = 250.0;
    double start_radius_mm = 110.0;  // outside the lump
    double start_height_mm = 60.0;

    [[nodiscard]] dvec2 within(const dvec2& radius_height_mm) const noexcept {
        return {std::clamp(radius_height_mm.x, least_radius_mm, most_radius_mm),
                std::clamp(radius_height_mm.y, least_height_mm, most_height_mm)};
    }
};

// Smaller changes of a rate-control stick, as a fraction of its travel, are noise.
constexpr double kPushNoise = 0.05;

struct DeviceInput {
    enum class Motion : std::uint8_t {
        kNone,  // a pedal: no tool
        kRate,  // the hand sets the tool's velocity, mm/s
        kPlace  // the hand sets the tool's position, mm
    };
    Motion motion = Motion::kNone;
    dvec2 rate_mm_s{0.0};  // radius, height
    dvec2 push{0.0};       // the push that asks for that rate, of the travel beyond the dead band, -1 to 1
    dvec2 place_mm{0.0};   // radius, height
    // In addition to both: the distance by which the hand has pushed the tool since plugging in. The reader
    // uses the change of this sum, so that no report is lost.
    dvec2 travelled_mm{0.0};
    double press_mm = 0.0;  // distance by which a trigger pushes the tool inwards
    bool button = false;
    // The requested speed of the work while the button is held, directly (0: no request) or by its rate of
    // change.
    double rev_min = 0.0;
    double change_rev_min_s = 0.0;
    bool shows_wall = false;  // the device renders a spring by itself along the radius
    bool is_live = false;     // false: nothing plugged in, or silent for too long; ignore all fields above
    // The position is current: a report has just arrived, or the device reports only changes.
    bool is_fresh = false;
    std::uint32_t buttons = 0;    // bit 0 is the first; for screens
    double force_fraction = 0.0;  // fraction of the last ordered force that the gate passed, 0 to 1
    std::uint64_t heartbeat = 0;  // counts the I/O thread's rounds; if it stops, the thread hangs
    std::uint64_t refreshed = 0;  // counts the rounds in which is_fresh was true
};

// The haptic thread's order, once a tick.
struct ForceOrder {
    dvec2 force_n{0.0};  // on the tool: outwards, upwards
    double tangential_n =
        0.0;             // along the turning wall: devices without that axis may render it as a vibration
    dvec2 tool_mm{0.0};  // radius and height that the force was computed for
    bool turns = false;
    WorkFelt work = {};       // the contact behind the force
    std::uint64_t ticks = 0;  // counts orders; if it stops, the haptic thread hangs
    // Set by the gate: orders stopped for starved_ns, so the loop must be dead.
    bool is_starved = false;
};

// A local model of the work, which a device renders by itself between two orders: a wall at a radius, of
// known stiffness, that exerts exactly the ordered force at the tool's position. A joystick's spring or a
// trigger's resistance then responds at the device's own rate, not at that of USB. Pure; any thread. mm, N.
// Source: local models of an environment for a slow link, e.g. Adams and Hannaford, "Stable haptic
// interaction with virtual environments", IEEE T-RO 15(3), 1999, for the coupling; the wall is the paper's F
// = K d.
struct LocalWall {
    double contact_mm = 0.0;  // the radius at which the force is zero
    bool is_outside = false;  // true: the work lies at smaller radii and pushes outwards; false: the reverse
    double stiffness_n_per_mm = 0.0;

    // The force on a tool at this radius, outwards positive.
    [[nodiscard]] double force_n(double radius_mm) const noexcept {
        const double force = stiffness_n_per_mm * (contact_mm - radius_mm);
        return (force > 0.0) == is_outside ? force : 0.0;
    }
};

// Empty while the work does not push along the radius.
[[nodiscard]] inline std::optional<LocalWall> local_wall(const ForceOrder& order,
                                                         double stiffness_n_per_mm) noexcept {
    constexpr double kNothingN = 1e-3;
    if (std::abs(order.force_n.x) < kNothingN) return std::nullopt;
    return LocalWall{.contact_mm = order.tool_mm.x + order.force_n.x / stiffness_n_per_mm,
                     .is_outside = order.force_n.x > 0.0,
                     .stiffness_n_per_mm = stiffness_n_per_mm};
}

}  // namespace onggi::haptics::hid

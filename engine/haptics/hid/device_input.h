// What a device says of the hand, and what it is told of the work: plain values between the I/O thread and
// the haptic thread, through mailboxes. mm, N, s; wheel frame of hand_sample.h, the tool in the plane z = 0
// right of the wheel: x is the radius, y the height.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "engine/haptics/haptic_device.h"
#include "engine/math/math.h"

namespace onggi::haptics::hid {

// Where a tool may go. A device moves it in two axes, radius and height: the pot is round.
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

struct DeviceInput {
    enum class Motion : std::uint8_t {
        kNone,  // a pedal: no tool at all
        kRate,  // the hand says how fast the tool moves, mm/s
        kPlace  // the hand holds the tool: where it is, mm
    };
    Motion motion = Motion::kNone;
    dvec2 rate_mm_s{0.0};  // radius, height
    dvec2 push{0.0};       // the push that asks for that rate, of the travel beyond the dead band, -1 to 1
    dvec2 place_mm{0.0};   // radius, height
    // Besides either: how far the hand has pushed the tool since it was plugged in, a sum that only its
    // changes are taken from, so that no report is missed.
    dvec2 travelled_mm{0.0};
    double press_mm = 0.0;  // how far the tool reaches inwards from where it stands: a trigger's travel
    bool button = false;
    // How fast the work shall turn while the button is held: by itself, 0 for no wish, or by how fast it
    // shall change.
    double rev_min = 0.0;
    double change_rev_min_s = 0.0;
    bool shows_wall = false;  // what is plugged in answers along the radius by a wall of its own
    bool is_live = false;     // false: nothing plugged in, or silent for too long; nothing above counts
    // The place is known to be as it is said: a report has just come, or the device is one whose silence says
    // that nothing has changed.
    bool is_fresh = false;
    std::uint32_t buttons = 0;    // bit 0 the first; for screens
    double force_fraction = 0.0;  // of the force ordered last, what the gate let through; 0 to 1
    std::uint64_t heartbeat = 0;  // counts the I/O thread's rounds: it must not stand still
    std::uint64_t refreshed = 0;  // counts those of them in which it was fresh
};

// The haptic thread's order, once a tick.
struct ForceOrder {
    dvec2 force_n{0.0};         // on the tool: outwards, upwards
    double tangential_n = 0.0;  // along the turning wall: devices without that axis may show it as a tremor
    dvec2 tool_mm{0.0};         // radius, height the force was worked out for
    bool turns = false;
    WorkFelt work = {};       // what the force came from
    std::uint64_t ticks = 0;  // counts orders: it must not stand still
    // Set by the gate: orders came once, and have stayed away for so long that the loop must be dead.
    bool is_starved = false;
};

// The work as the device may show it by itself between two orders: a wall at a radius, of a known stiffness,
// that gives at the tool's place exactly the ordered force. A joystick's own spring or a trigger's
// resistance then answers the hand at the device's speed, not at that of USB. Pure; any thread. mm, N.
// Source: local models of an environment for a slow link, e.g. Adams and Hannaford, "Stable haptic
// interaction with virtual environments", IEEE T-RO 15(3), 1999, for the coupling; the wall is the paper's F
// = K d.
struct LocalWall {
    double contact_mm = 0.0;  // the radius at which the force is zero
    bool is_outside =
        false;  // true: the work lies at smaller radii and pushes outwards; false: the other way
    double stiffness_n_per_mm = 0.0;

    // On a tool at this radius, outwards positive.
    [[nodiscard]] double force_n(double radius_mm) const noexcept {
        const double force = stiffness_n_per_mm * (contact_mm - radius_mm);
        return (force > 0.0) == is_outside ? force : 0.0;
    }
};

// None while the work does not push along the radius.
[[nodiscard]] inline std::optional<LocalWall> local_wall(const ForceOrder& order,
                                                         double stiffness_n_per_mm) noexcept {
    constexpr double kNothingN = 1e-3;
    if (std::abs(order.force_n.x) < kNothingN) return std::nullopt;
    return LocalWall{.contact_mm = order.tool_mm.x + order.force_n.x / stiffness_n_per_mm,
                     .is_outside = order.force_n.x > 0.0,
                     .stiffness_n_per_mm = stiffness_n_per_mm};
}

}  // namespace onggi::haptics::hid

// One haptic tick as a pure function of state and input: clay, wheel and safety, no thread and no clock.
// The same inputs give the same bits everywhere (live, throw, replay). Any one thread at a time; the tick
// allocates nothing and cannot fail. mm, N, s, rad.
#pragma once

#include <cstdint>
#include <utility>
#include <variant>

#include "engine/haptics/safety_chain.h"
#include "engine/haptics/tool_state.h"
#include "engine/haptics/velocity_estimator.h"
#include "engine/record/session_format.h"
#include "game/clay/paper_clay.h"
#include "game/clay/studio/studio_clay.h"
#include "game/clay/wheel_angle.h"
#include "game/haptic/device_force.h"

namespace onggi::haptic {

// What both clays are ticked with; each takes its own. clay::check() must hold for both.
struct HapticParameters {
    clay::PaperParameters paper;
    clay::StudioParameters studio;
    haptics::SafetyLimits safety;
    DeviceFeel feel;

    // The tick rate, which both hold.
    [[nodiscard]] double rate_hz() const { return paper.rate_hz; }
    void set_rate_hz(double rate_hz) { paper.rate_hz = studio.rate_hz = rate_hz; }
    [[nodiscard]] double dt_s() const { return 1.0 / paper.rate_hz; }
};

// All that a later tick depends on. One of the two clays is on the wheel, and stays the one it is.
struct HapticState {
    HapticState() = default;
    explicit HapticState(clay::PaperClay start) : clay(std::move(start)) {}
    explicit HapticState(clay::StudioClay start) : clay(std::move(start)) {}

    std::variant<clay::PaperClay, clay::StudioClay> clay;
    clay::WheelAngle wheel;  // under the paper's clay; the studio's has its own
    // The tool of the last tick, within its limits: what is recorded. Far above the clay before the first.
    haptics::ToolState tool{.position_mm = {0.0, haptics::kWorkspaceMm, 0.0}};
    haptics::SafetyState safety;          // of the device, not of the clay: it outlives a fresh lump
    haptics::VelocityEstimator velocity;  // the same
    std::uint64_t ticks = 0;              // since the lump was fresh

    // The clay that is there; null where it is the other one.
    [[nodiscard]] clay::PaperClay* paper() { return std::get_if<clay::PaperClay>(&clay); }
    [[nodiscard]] const clay::PaperClay* paper() const { return std::get_if<clay::PaperClay>(&clay); }
    [[nodiscard]] clay::StudioClay* studio() { return std::get_if<clay::StudioClay>(&clay); }
    [[nodiscard]] const clay::StudioClay* studio() const { return std::get_if<clay::StudioClay>(&clay); }

    // Of either.
    [[nodiscard]] double height_mm() const;
    [[nodiscard]] double volume_mm3() const;
    // Elements of the paper's clay; N of the studio's lump, which are not its rings of this moment.
    [[nodiscard]] int element_count() const;
    [[nodiscard]] int sector_count() const;  // 1 for the paper's, which is round everywhere
    [[nodiscard]] const clay::Rotation& heading() const;

    // Of what makes the clay and the wheel what they are, not of the device's safety: a replay has no device.
    [[nodiscard]] std::uint64_t hash() const;
    // Puts a fresh lump on the wheel; the safety state stays. No allocation when `fresh` has the same clay
    // with as many elements.
    void restart_from(const HapticState& fresh) noexcept;
    // As StudioClay::take_memory(): before a tick has it.
    void take_memory() noexcept;
};

struct TickResult {
    clay::ContactForces forces;    // of the first hand; their sum F of Eq. (3) is what is recorded
    dvec3 limited_force_n{0.0};    // what goes to the device
    bool hash_due = false;         // this tick was the last of a run of record::kHashInterval
    std::uint64_t state_hash = 0;  // after this tick, when due

    // Of the studio's clay.
    clay::ContactForces second_forces;  // of the second hand or the assist
    dvec3 second_position_mm{0.0};
    bool has_second = false;
    clay::studio::Side side = clay::studio::Side::kFree;
    clay::studio::Side second_side = clay::studio::Side::kFree;
    double wheel_load_n_mm = 0.0;   // of the hands' friction, against the turning
    clay::studio::GripReport grip;  // of a guided hand
};

// What a device says besides the tool, and what the loop knows of its own time. As it stands: every device
// and every period is as it should be.
struct DeviceTick {
    double dt_s = 0.0;       // since the last tick; 0: the fixed step
    std::uint32_t late = 0;  // periods missed since
    haptics::HandSigns signs;
    bool stop = false;        // somebody wants no force
    dvec3 test_force_n{0.0};  // the staff's test, beside the clay's force; a motor is behind it
    // The clay is another one and the hand is where it was. The studio's clay is told of a hand over the pot
    // for this tick: it would take it for the hand that it remembers, come through its walls.
    bool comes_anew = false;
};

// What the studio's clay is told when a hand does that.
[[nodiscard]] clay::StudioInput studio_input(const haptics::ToolState& tool) noexcept;

// Takes the tool, turns the wheel and the clay by one fixed step and works out the forces. Under the paper's
// clay the wheel turns exactly while its button is held, at full speed at once; under the studio's the button
// is the pedal. Nothing of `device` reaches the clay but by the tool that is recorded, so that a replay,
// which has none, is the same.
TickResult tick(HapticState& state, const haptics::ToolState& tool, const HapticParameters& parameters,
                const DeviceTick& device = {}) noexcept;

}  // namespace onggi::haptic

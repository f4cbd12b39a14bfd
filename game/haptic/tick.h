// One haptic tick as a pure function of state and input: clay, wheel and safety, without thread or clock. The
// same inputs give the same bits everywhere (live, throw, replay). One thread at a time; the tick does not
// allocate and cannot fail. mm, N, s, rad.
#pragma once

#include <cstdint>
#include <utility>
#include <variant>

#include "engine/haptics/safety_chain.h"
#include "engine/haptics/velocity_estimator.h"
#include "game/clay/paper_clay.h"
#include "game/clay/studio/studio_clay.h"
#include "game/clay/wheel_angle.h"
#include "game/haptic/device_force.h"
#include "game/tool/tool_state.h"

namespace onggi::haptic {

// Parameters of both clays; each clay uses its own. clay::check() must hold for both.
struct HapticParameters {
    clay::PaperParameters paper;
    clay::StudioParameters studio;
    haptics::SafetyLimits safety;
    DeviceFeel feel;

    // The tick rate, the same for both clays.
    [[nodiscard]] double rate_hz() const { return paper.rate_hz; }
    void set_rate_hz(double rate_hz) { paper.rate_hz = studio.rate_hz = rate_hz; }
    [[nodiscard]] double dt_s() const { return 1.0 / paper.rate_hz; }
};

// Everything a later tick depends on. One of the two clays is on the wheel; its kind never changes.
struct HapticState {
    HapticState() = default;
    explicit HapticState(clay::PaperClay start) : clay(std::move(start)) {}
    explicit HapticState(clay::StudioClay start) : clay(std::move(start)) {}

    std::variant<clay::PaperClay, clay::StudioClay> clay;
    clay::WheelAngle wheel;  // of the paper's clay; the studio's clay has its own wheel
    // The tool of the last tick, within its limits, as it is recorded. Far above the clay before the first
    // tick.
    tool::ToolState tool{.position_mm = {0.0, haptics::kWorkspaceMm, 0.0}};
    haptics::SafetyState safety;          // belongs to the device, not to the clay: a fresh lump keeps it
    haptics::VelocityEstimator velocity;  // likewise
    std::uint64_t ticks = 0;              // since the lump was fresh

    // The clay of that kind; null if the other kind is on the wheel.
    [[nodiscard]] clay::PaperClay* paper() { return std::get_if<clay::PaperClay>(&clay); }
    [[nodiscard]] const clay::PaperClay* paper() const { return std::get_if<clay::PaperClay>(&clay); }
    [[nodiscard]] clay::StudioClay* studio() { return std::get_if<clay::StudioClay>(&clay); }
    [[nodiscard]] const clay::StudioClay* studio() const { return std::get_if<clay::StudioClay>(&clay); }

    // For both kinds:
    [[nodiscard]] double height_mm() const;
    [[nodiscard]] double volume_mm3() const;
    // Elements of the paper's clay; N of the studio's lump, which differs from its present ring count.
    [[nodiscard]] int element_count() const;
    [[nodiscard]] int sector_count() const;  // 1 for the paper's clay, which is always round
    [[nodiscard]] const clay::Rotation& heading() const;

    // Hash of the clay and the wheel, not of the device's safety: a replay has no device.
    [[nodiscard]] std::uint64_t hash() const;
    // Puts a fresh lump on the wheel; the safety state stays. No allocation when `fresh` has the same clay
    // with as many elements.
    void restart_from(const HapticState& fresh) noexcept;
    // Calls StudioClay::take_memory(), before the first tick.
    void take_memory() noexcept;
};

struct TickResult {
    clay::ContactForces forces;  // on the first hand; recordings hold their sum F of Eq. (3)
    dvec3 limited_force_n{0.0};  // to the device

    // For the studio's clay:
    clay::ContactForces second_forces;  // on the second hand or the assist
    dvec3 second_position_mm{0.0};
    bool has_second = false;
    tool::Side side = tool::Side::kFree;
    tool::Side second_side = tool::Side::kFree;
    double wheel_load_n_mm = 0.0;   // from the hands' friction, against the turning
    clay::studio::GripReport grip;  // of a guided hand
};

// The device's other data besides the tool, and the loop's timing. The defaults mean that device and timing
// are in order.
struct DeviceTick {
    double dt_s = 0.0;       // since the last tick; 0: the fixed step
    std::uint32_t late = 0;  // periods missed since the last tick
    haptics::DeviceSigns signs;
    bool stop = false;        // a person switched the force off
    dvec3 test_force_n{0.0};  // force of the staff's test, added to the clay's; counts as driven by a motor
    // The clay was replaced under the hand. For this tick the studio's clay gets the hand above the pot;
    // otherwise it would take the hand for the remembered one that moved through its walls.
    bool comes_anew = false;
};

// Applies the tool, advances the wheel and the clay by one fixed step and computes the forces. With the
// paper's clay the wheel turns exactly while its button is held, immediately at full speed; with the
// studio's, the button is the pedal. `device` affects the clay only through the recorded tool, so that a
// replay without a device is the same.
TickResult tick(HapticState& state, const tool::ToolState& tool, const HapticParameters& parameters,
                const DeviceTick& device = {}) noexcept;

}  // namespace onggi::haptic

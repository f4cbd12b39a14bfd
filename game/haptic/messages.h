// Messages between the haptic thread and the others. Plain values, copied through wait-free hand-offs. mm, N,
// s.
#pragma once

#include <cstdint>
#include <type_traits>

#include "engine/haptics/safety_chain.h"
#include "engine/math/math.h"
#include "game/haptic/force_test.h"
#include "game/haptic/pot_copy.h"
#include "game/haptic/tick.h"
#include "game/tool/tool_state.h"

namespace onggi::haptic {

// The clay's warning: the largest load index, its height and cause; and the first ring that failed.
struct LoadReport {
    double index = 0.0;
    double height_mm = 0.0;
    clay::studio::Cause cause = clay::studio::Cause::kNone;
    double strength_kpa = 0.0;      // of the clay at that height
    clay::studio::Failure failure;  // in words: clay::sentence()
};

// State of the safety chain, for screens and logs.
struct SafetyReport {
    double ramp = 0.0;                // ramp of the force after a start or a fault, 0 to 1
    double gain = 1.0;                // remaining fraction of the force after missed periods
    double presence = 1.0;            // 0: no person is there
    double energy_mj = 0.0;           // balance of the passivity observer
    double taken_mj = 0.0;            // energy that the device took from the hand, since the job started
    double given_mj = 0.0;            // energy that the device gave to the hand
    double damping_n_s_per_mm = 0.0;  // added by the passivity controller
    double mean_force_n = 0.0;        // root mean square over the budget's time
    double largest_force_n = 0.0;     // largest force sent to a device since the job started
    std::uint64_t late_periods = 0;
    std::uint32_t fault_count = 0;
    std::uint32_t speed_stops = 0;
    std::uint32_t silences = 0;  // times that the watchdog found the loop stalled
};

// Haptic thread to main thread, newest wins: one tick's data for the picture and the display of forces.
struct Snapshot {
    std::uint64_t tick = 0;             // ticks since the lump was fresh
    std::uint64_t run = 0;              // number of lumps before this one
    std::uint64_t states_put = 0;       // number of states put on the wheel
    std::uint64_t skipped_periods = 0;  // since the job started
    std::uint64_t periods = 0;          // ticks since the job started, of all lumps
    tool::ToolState tool{};
    TickResult result{};  // forces of both hands, the device's force, sides, the assist's place
    haptics::Fault fault = haptics::Fault::kNone;
    SafetyReport safety{};
    ForceTestReport force_test{};
    dvec2 wheel_direction{1.0, 0.0};  // cos and sin of the wheel's angle, counter-clockwise from above
    bool wheel_turning = false;
    double wheel_speed_rad_s = 0.0;
    // Only for the studio's clay:
    LoadReport load{};
    double on_wheel_mm3 = 0.0;
    double hand_film = 0.0;   // water on the hands, 0 to 1
    bool is_cut_off = false;  // the pot is finished
    clay::ClayBody body = clay::ClayBody::kStoneware;
    // The rings, copied at a pace of their own; never null in the result of newest_snapshot().
    const pot::Pot* pot = nullptr;
    PotStamp pot_stamp{};
};

// A snapshot of the start, without a pot.
[[nodiscard]] Snapshot first_snapshot(const HapticState& start, const HapticParameters& parameters);
// Fills in state and result; the job fills in run, skipped_periods and pot.
void fill_snapshot(Snapshot& snapshot, const HapticState& state, const TickResult& result,
                   const HapticParameters& parameters) noexcept;

// Main thread to haptic thread; in order, lossless.
enum class Command : std::uint8_t {
    kFreshLump,   // put the start lump on the wheel again
    kRearmForce,  // reset a latched fault; the force ramps up again
    kLetGo,       // the wheel is unattended: no force until kTakeHold
    kTakeHold,    // a person is there; the force ramps up again
    kTestForce,   // test the device that has the tool; a fresh lump ends the test
};

// Haptic thread to the recording thread; in order, one per tick.
struct TickRecord {
    static constexpr std::uint32_t kFreshLump = 1U << 1U;  // the lump was made fresh before this tick
    static constexpr std::uint32_t kStatePut = 1U << 4U;   // another state was put on before this tick
    static constexpr std::uint32_t kFault = 1U << 3U;      // a fault is latched: the device got no force

    std::uint32_t tick = 0;  // since the lump was fresh; 32 bits last five days at 10 kHz
    std::uint32_t flags = 0;
    std::uint32_t run = 0;  // number of lumps before this one
    tool::ToolState tool;   // as passed to the clay
    dvec3 force_n{0.0};     // F of Eq. (3), before the safety chain
};
static_assert(sizeof(TickRecord) <= 192, "three cache lines; ten seconds at 4 kHz are 7.7 MB");
static_assert(std::is_trivially_copyable_v<TickRecord>);

}  // namespace onggi::haptic

// What the haptic thread and the others say to each other. Plain values, copied through wait-free hand-offs.
// mm, N, s.
#pragma once

#include <cstdint>
#include <type_traits>

#include "engine/haptics/safety_chain.h"
#include "engine/haptics/tool_state.h"
#include "engine/math/math.h"
#include "game/haptic/force_test.h"
#include "game/haptic/pot_copy.h"
#include "game/haptic/tick.h"

namespace onggi::haptic {

// The clay's warning: the largest load index, where, and by what; and the first ring that gave way.
struct LoadReport {
    double index = 0.0;
    double height_mm = 0.0;
    clay::studio::Cause cause = clay::studio::Cause::kNone;
    double strength_kpa = 0.0;      // of the clay there
    clay::studio::Failure failure;  // clay::sentence() says it in words
};

// What the safety chain does to the force, for screens and logs.
struct SafetyReport {
    double ramp = 0.0;                // 0 to 1: how much of the force is there after a start or a fault
    double gain = 1.0;                // what missed periods leave of it
    double presence = 1.0;            // 0: nobody is there
    double energy_mj = 0.0;           // the observer's balance
    double taken_mj = 0.0;            // by the device from the hand, since the job started
    double given_mj = 0.0;            // by the device to the hand
    double damping_n_s_per_mm = 0.0;  // what the controller adds
    double mean_force_n = 0.0;        // root of the mean square over the budget's time
    double largest_force_n = 0.0;     // that a device was told since the job started
    std::uint64_t late_periods = 0;
    std::uint32_t fault_count = 0;
    std::uint32_t speed_stops = 0;
    std::uint32_t silences = 0;  // how often the watchdog found the loop standing still
};

// Haptic thread to main thread, newest wins: all a picture and a display of forces need of one tick.
struct Snapshot {
    std::uint64_t tick = 0;             // ticks since the lump was fresh
    std::uint64_t run = 0;              // how many lumps came before this one
    std::uint64_t states_put = 0;       // how many states were put on the wheel
    std::uint64_t skipped_periods = 0;  // since the job started
    std::uint64_t periods = 0;          // ticked since then, whatever the lump
    haptics::ToolState tool;
    TickResult result;  // forces of both hands, what the device got, sides, where the assist is
    haptics::Fault fault = haptics::Fault::kNone;
    SafetyReport safety;
    ForceTestReport force_test;
    dvec2 wheel_direction{1.0, 0.0};  // cos and sin of the wheel's angle, counter-clockwise from above
    bool wheel_turning = false;
    double wheel_speed_rad_s = 0.0;
    // Of the studio's clay.
    LoadReport load;
    double on_wheel_mm3 = 0.0;
    double hand_film = 0.0;   // water on the hands, 0 to 1
    bool is_cut_off = false;  // the pot is done
    clay::ClayBody body = clay::ClayBody::kStoneware;
    // The rings, which come at a pace of their own; never null in what newest_snapshot() gives.
    const pot::Pot* pot = nullptr;
    PotStamp pot_stamp;
};

// A snapshot of the start, without a pot.
[[nodiscard]] Snapshot first_snapshot(const HapticState& start, const HapticParameters& parameters);
// What state and result say; run, skipped_periods and pot are the job's to fill.
void fill_snapshot(Snapshot& snapshot, const HapticState& state, const TickResult& result,
                   const HapticParameters& parameters) noexcept;

// Main thread to haptic thread, in order, none lost.
enum class Command : std::uint8_t {
    kFreshLump,   // put the start lump on the wheel again
    kRearmForce,  // take a latched fault back; the force returns through its ramp
    kLetGo,       // nobody is at the wheel: no force until somebody is
    kTakeHold,    // somebody is; the force returns through its ramp
    kTestForce,   // the staff's test of whichever hand has the tool; a fresh lump ends it
};

// Haptic thread to whoever records, in order: one a tick.
struct TickRecord {
    static constexpr std::uint32_t kFreshLump = 1U << 1U;  // the lump was made fresh before this tick
    static constexpr std::uint32_t kHashDue = 1U << 2U;    // a BlockHash goes with it
    static constexpr std::uint32_t kStatePut = 1U << 4U;   // another state was put on the wheel before it
    static constexpr std::uint32_t kFault = 1U << 3U;      // the device got no force: a fault is latched

    std::uint32_t tick = 0;  // since the lump was fresh; 4e9 of them are five days at 10 kHz
    std::uint32_t flags = 0;
    std::uint32_t run = 0;    // how many lumps came before this one
    haptics::ToolState tool;  // as the clay was told
    dvec3 force_n{0.0};       // F of Eq. (3), before the safety chain
};
static_assert(sizeof(TickRecord) <= 192, "three cache lines; ten seconds at 4 kHz are 7.7 MB");
static_assert(std::is_trivially_copyable_v<TickRecord>);

// The state's hash after each full block of ticks; it is sent before the record that says kHashDue.
struct BlockHash {
    std::uint64_t ticks = 0;  // since the lump was fresh
    std::uint64_t state_hash = 0;
};

}  // namespace onggi::haptic

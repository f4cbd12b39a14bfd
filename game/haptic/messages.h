// What the haptic thread and the others say to each other. Plain values, copied through wait-free hand-offs.
// mm, N, s.
#pragma once

#include <cstdint>
#include <type_traits>
#include <vector>

#include "engine/haptics/safety_chain.h"
#include "engine/haptics/tool_state.h"
#include "engine/math/math.h"
#include "game/clay/paper_clay.h"
#include "game/haptic/tick.h"

namespace onggi::haptic {

// Haptic thread to main thread, newest wins: all a picture and a display of forces need of one tick. The
// vector keeps its size for the whole run, so that filling it never allocates.
struct Snapshot {
    std::uint64_t tick = 0;             // ticks since the lump was fresh
    std::uint64_t run = 0;              // how many lumps came before this one
    std::uint64_t skipped_periods = 0;  // since the job started
    haptics::ToolState tool;
    clay::ContactForces forces;  // what the clay does to the tool: Fs, Fv, Ff
    dvec3 limited_force_n{0.0};  // what the device got
    haptics::Fault fault = haptics::Fault::kNone;
    dvec2 wheel_direction{1.0, 0.0};  // cos and sin of the wheel's angle, counter-clockwise from above
    bool wheel_turning = false;
    std::vector<float> radii_mm;  // R_i, bottom first
};

// A snapshot of the start, with its vector in its final size.
[[nodiscard]] Snapshot first_snapshot(const HapticState& start);
// What state and result say; run and skipped_periods are the job's to fill. No allocation when the snapshot
// came from first_snapshot() of a state with as many elements.
void fill_snapshot(Snapshot& snapshot, const HapticState& state, const TickResult& result) noexcept;

// Main thread to haptic thread, in order, none lost.
enum class Command : std::uint8_t {
    kFreshLump,   // put the start lump on the wheel again
    kRearmForce,  // take a latched fault back; the force returns through its ramp
};

// Haptic thread to whoever records, in order: one a tick, a cache line each.
struct TickRecord {
    static constexpr std::uint32_t kWheelButton = 1U << 0U;
    static constexpr std::uint32_t kFreshLump = 1U << 1U;  // the lump was made fresh before this tick
    static constexpr std::uint32_t kHashDue = 1U << 2U;    // a BlockHash goes with it
    static constexpr std::uint32_t kFault = 1U << 3U;      // the device got no force: a fault is latched

    std::uint32_t tick = 0;  // since the lump was fresh; 4e9 of them are five days at 10 kHz
    std::uint32_t flags = 0;
    dvec3 position_mm{0.0};  // of the tool, as the clay was told
    double radius_mm = 0.0;
    dvec3 force_n{0.0};  // F of Eq. (3), before the safety chain

    [[nodiscard]] haptics::ToolState tool() const {
        return {
            .position_mm = position_mm, .radius_mm = radius_mm, .wheel_button = (flags & kWheelButton) != 0};
    }
};
static_assert(sizeof(TickRecord) == 64, "a record is one cache line; ten seconds at 4 kHz are 2.6 MB");
static_assert(std::is_trivially_copyable_v<TickRecord>);

// The state's hash after each full block of ticks; it is sent before the record that says kHashDue.
struct BlockHash {
    std::uint64_t ticks = 0;  // since the lump was fresh
    std::uint64_t state_hash = 0;
};

}  // namespace onggi::haptic

// The staff's test of a hand: small pushes along each axis in turn, known beforehand, which go through the
// whole safety chain like any force, and what the hand answered. Counted in ticks, so that the same ticks
// give the same forces. Haptic thread; allocates nothing. mm, N, s.
#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/haptics/safety_chain.h"
#include "engine/math/math.h"

namespace onggi::haptic {

// Felt by any hand, and below what any device may give for ever.
constexpr double kTestForceN = 0.6;
constexpr double kTestPushS = 0.4;  // along each of the three axes
constexpr int kTestPushes = 3;      // up, right, towards the visitor
// The force comes back through its ramp first, where nobody was at the wheel.
constexpr double kTestWaitsS = 3.0;

struct ForceTestReport {
    enum class Stage : std::uint8_t {
        kNone,
        kWaits,  // until the whole force is there
        kPushes,
        kDone,
        kNobody,  // the force did not come: the hand says that nobody holds it
        kBroken,  // by a fault, a stop, another hand that took the tool, or a fresh lump
    };
    Stage stage = Stage::kNone;
    std::size_t hand = 0;  // of HapticDevice::capabilities_of_hands()
    dvec3 given_n{0.0};    // the largest of each push that the safety chain let through
    dvec3 moved_mm{0.0};   // how far the tool went along with each

    friend bool operator==(const ForceTestReport&, const ForceTestReport&) = default;
};

// What is asked of the hand, so long after the first push began: up, right, towards the visitor, each from
// nothing to kTestForceN and back without a corner. Zero before and after.
[[nodiscard]] dvec3 test_force_n(double time_s) noexcept;

class ForceTest {
  public:
    void begin(std::size_t hand) noexcept;
    void end() noexcept;
    [[nodiscard]] bool runs() const noexcept {
        return report_.stage == ForceTestReport::Stage::kWaits ||
               report_.stage == ForceTestReport::Stage::kPushes;
    }
    // Once a tick, before the chain: what to add to the clay's force. `hand` has the tool now.
    [[nodiscard]] dvec3 step(const haptics::SafetyState& safety, std::size_t hand, double dt_s) noexcept;
    // And after it: where the tool was in this tick, and what the chain let through.
    void see(const dvec3& position_mm, const dvec3& given_n) noexcept;
    [[nodiscard]] const ForceTestReport& report() const noexcept { return report_; }

  private:
    ForceTestReport report_;
    std::uint64_t ticks_ = 0;  // in this stage
    int push_ = -1;            // which is on; -1: none yet
    int seen_push_ = -1;
    dvec3 from_mm_{0.0};  // the tool when that one began
};

}  // namespace onggi::haptic

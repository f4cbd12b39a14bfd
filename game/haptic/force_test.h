// The staff's test of a device: small known pushes along each axis in turn, which pass the whole safety chain
// like any force, and the hand's response to them. Counted in ticks, so that the same ticks have the same
// forces. Haptic thread; does not allocate. mm, N, s.
#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/haptics/safety_chain.h"
#include "engine/math/math.h"

namespace onggi::haptic {

// Strong enough to feel in any hand, and below the continuous force of every device.
constexpr double kTestForceN = 0.6;
constexpr double kTestPushS = 0.4;  // along each of the three axes
constexpr int kTestPushes = 3;      // up, right, towards the visitor
// The longest wait for the force to come back through its ramp, as after an idle time.
constexpr double kTestWaitsS = 3.0;

struct ForceTestReport {
    enum class Stage : std::uint8_t {
        kNone,
        kWaits,  // for the full force
        kPushes,
        kDone,
        kNobody,  // the force did not come back: the hand reports that no person holds it
        kBroken,  // aborted: a fault, a stop, another device that took the tool, or a fresh lump
    };
    Stage stage = Stage::kNone;
    std::size_t device = 0;  // index in HapticDevice::capabilities_of_devices()
    dvec3 given_n{0.0};      // largest force of each push that passed the safety chain
    dvec3 moved_mm{0.0};     // the tool's travel along each push

    friend bool operator==(const ForceTestReport&, const ForceTestReport&) = default;
};

// The force of the test at time_s after the first push began: up, right, towards the visitor, each from 0 to
// kTestForceN and back with a smooth curve. Zero before and after.
[[nodiscard]] dvec3 test_force_n(double time_s) noexcept;

class ForceTest {
  public:
    void begin(std::size_t device) noexcept;
    void end() noexcept;
    [[nodiscard]] bool runs() const noexcept {
        return report_.stage == ForceTestReport::Stage::kWaits ||
               report_.stage == ForceTestReport::Stage::kPushes;
    }
    // Once a tick, before the safety chain. Returns the force to add to the clay's. `device` has the tool
    // now.
    [[nodiscard]] dvec3 step(const haptics::SafetyState& safety, std::size_t device, double dt_s) noexcept;
    // Once a tick, after the chain: the tool's position in this tick, and the force that passed the chain.
    void see(const dvec3& position_mm, const dvec3& given_n) noexcept;
    [[nodiscard]] const ForceTestReport& report() const noexcept { return report_; }

  private:
    ForceTestReport report_;
    std::uint64_t ticks_ = 0;  // ticks of this stage
    int push_ = -1;            // the current push; -1 before the first
    int seen_push_ = -1;
    dvec3 from_mm_{0.0};  // the tool's place when that push began
};

}  // namespace onggi::haptic

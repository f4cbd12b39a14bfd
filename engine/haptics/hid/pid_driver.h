// Driver of force-feedback joysticks (USB PID 1.0). I/O thread. The stick holds the tool: X is the radius,
// pulling towards the hand lowers the tool. The work's radial force is a one-sided spring that the device
// itself renders, independent of USB's speed; the vertical force is a constant-force effect; damper and
// friction, if the device has them, act during contact. Without springs the radial force is a constant-force
// effect too. A constant force closes a loop over USB, updated every 4 ms, so the stiffness on such an axis
// is limited to what is stable there (game/haptic/device_force.h).
//
// Every effect ends by itself after half a second and is restarted in time: when this program dies, the force
// ends. Never tried on hardware by this project.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "engine/haptics/hid/hid_driver.h"
#include "engine/haptics/hid/hid_port.h"
#include "engine/haptics/hid/pid_reports.h"
#include "engine/haptics/safety_chain.h"

namespace onggi::haptics::hid {

// Detects from a device's reports whether it reports continuously or only changes. No descriptor states it,
// and it decides whether silence means a still hand or a failed device. One thread at a time; no allocation.
//
// A device that sends the same report twice in a row reports continuously, and its silence is a failure. A
// device that reports again after a long silence reports only changes: some firmwares repeat the last report
// once or twice and then rest. Until either is known, silence counts as a still hand, for a time that the
// driver limits.
class ReportHabit {
  public:
    // Call with every report of the hand's position.
    void take(std::span<const std::uint8_t> report) noexcept {
        Report now;
        now.size = std::min(report.size(), now.bytes.size());
        std::copy_n(report.begin(), now.size, now.bytes.begin());
        repeats_ = repeats_ || (was_heard_ && now == last_);
        rests_ = rests_ || silent_rounds_ >= kLongRounds;
        last_ = now;
        was_heard_ = true;
        silent_rounds_ = 0;
    }
    // Call in every round of the I/O thread: silence is counted in rounds that read the device, so that a
    // delayed thread does not count as silence.
    void round() noexcept { silent_rounds_ = std::min(silent_rounds_ + 1, kLongRounds); }

    [[nodiscard]] bool reports_all_the_time() const noexcept { return repeats_ && !rests_; }

  private:
    // A tenth of a second: each round waits 4 ms for a report.
    static constexpr int kLongRounds = 25;

    Report last_;
    bool was_heard_ = false;
    bool repeats_ = false;
    bool rests_ = false;
    int silent_rounds_ = 0;
};

struct PidMapping {
    ToolReach reach;  // the stick's travel spans it
    // The force at the hand at full magnitude. PID has fractions, not newtons, and makers seldom state the
    // force; if this value is too small, the hand gets too much. So an unmeasured stick counts as stronger
    // than any known one, and feels weak until its force is measured with a spring balance.
    double full_scale_n = 50.0;
    double peak_n = kKioskPeakForceN;  // the largest force to request
    double stiffness_n_per_mm = 0.5;   // of the spring that the device renders
    double damping_fraction = 0.1;     // of its full damper, while in contact
};

class PidDriver final : public HidDriver {
  public:
    explicit PidDriver(const PidMapping& mapping = {}) : mapping_(mapping) {}

    [[nodiscard]] DeviceCapabilities capabilities() const override;
    // Resets the device, enables actuators, then creates, loads, sets and starts each effect with zero force.
    Result<void> start(const HidDeviceInfo& device, HidPort& port) override;
    void take_report(std::span<const std::uint8_t> report, std::int64_t now_ns) noexcept override;
    [[nodiscard]] DeviceInput input(std::int64_t now_ns) const noexcept override;
    Result<void> send(HidPort& port, const ForceOrder& order, std::int64_t now_ns) override;
    void stop(HidPort& port) noexcept override;

  private:
    // One effect in the device, and the reports last sent: equal reports are not sent twice.
    struct Effect {
        PidUsage type = PidUsage::kConstantForceType;
        Axis axis = Axis::kX;  // of a constant force
        std::uint8_t block = 0;
        std::optional<Report> told_x = std::nullopt;
        std::optional<Report> told_y = std::nullopt;
    };

    Result<void> begin(HidPort& port);
    // Empty if the device has no room for the effect.
    Result<std::optional<Effect>> load(HidPort& port, PidUsage type, Axis axis);
    [[nodiscard]] bool can_show_a_wall() const noexcept;
    Result<void> start_effects(HidPort& port);
    Result<void> tell(HidPort& port, Effect& effect, const ForceOrder& order);
    [[nodiscard]] PidCondition wall_condition(const ForceOrder& order) const noexcept;
    [[nodiscard]] double fraction_of_force(double force_n) const noexcept;
    [[nodiscard]] double mm_per_unit() const noexcept {
        return (mapping_.reach.most_radius_mm - mapping_.reach.least_radius_mm) / 2.0;
    }
    // The largest stiffness of the device's spring: a weak stick cannot be as stiff as wanted.
    [[nodiscard]] double stiffest_n_per_mm() const noexcept {
        return std::min(mapping_.stiffness_n_per_mm, mapping_.full_scale_n / mm_per_unit());
    }

    PidMapping mapping_;
    std::optional<PidLayout> layout_;
    bool shows_wall_ = false;
    std::vector<Effect> effects_;
    StickState stick_;
    PidDeviceState device_state_;
    bool was_heard_ = false;
    bool wheel_turns_ = false;
    std::int64_t heard_ns_ = 0;
    ReportHabit habit_;
    std::int64_t last_start_ns_ = 0;
    std::int64_t last_told_ns_ = 0;
    bool is_stopped_ = false;  // stopped because orders ran out
    bool is_started_ = false;  // last_start_ns_ and last_told_ns_ are valid
};

}  // namespace onggi::haptics::hid

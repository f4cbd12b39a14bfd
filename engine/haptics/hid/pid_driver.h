// Driver of force-feedback joysticks (USB PID 1.0). I/O thread. The stick holds the tool: X is the radius,
// pulling towards the hand lowers it. The work's radial force is a one-sided spring that the device itself
// runs (a wall that does not depend on how fast USB is); the vertical one a constant force; damper and
// friction, where the device has them, act while the tool touches. Without springs the radial force is a
// constant one too. A constant force closes a loop over USB, told every 4 ms: the work's stiffness on such an
// axis is bound to what is stable there (game/haptic/device_force.h).
//
// Every effect ends by itself after half a second and is started again in time: when this program dies, so
// does the force. Never tried on hardware by this project.
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

// Whether a device reports all the time or only what has changed, found out by its own reports. Nothing in a
// descriptor tells it, and it decides what a silence means: a still hand, or a device that has fallen mute.
// One thread at a time; no allocation.
//
// Who says the same twice running does not wait for a change: it reports all the time, and its silence is a
// lack. Who goes on after a long silence is one that may be silent: some firmwares say a last word or two
// and then rest. Until something is known a silence is taken for a still hand, which its driver bounds.
class ReportHabit {
  public:
    // Every report of where the hand is.
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
    // Every round of the I/O thread: only rounds that listened count, not one that the kernel kept waiting.
    void round() noexcept { silent_rounds_ = std::min(silent_rounds_ + 1, kLongRounds); }

    [[nodiscard]] bool reports_all_the_time() const noexcept { return repeats_ && !rests_; }

  private:
    // A tenth of a second: each listens for 4 ms.
    static constexpr int kLongRounds = 25;

    Report last_;
    bool was_heard_ = false;
    bool repeats_ = false;
    bool rests_ = false;
    int silent_rounds_ = 0;
};

struct PidMapping {
    ToolReach reach;  // the stick's travel spans it
    // The force at the hand of a full magnitude. PID tells shares, never newtons, and a stick's maker tells
    // them seldom: taken too small here, the hand would get too much. So an unmeasured stick counts as
    // stronger than any known one, and feels weak until somebody holds a spring balance to it.
    double full_scale_n = 50.0;
    double peak_n = kKioskPeakForceN;  // what it may be asked for
    double stiffness_n_per_mm = 0.5;   // of the wall it shows by itself
    double damping_fraction = 0.1;     // of its full damper, while in contact
    // 1 or -1 for constant forces: makers do not agree on the sense of a direction. A wrong one pulls the
    // tool into the work instead of pushing it out.
    double radius_sign = 1.0;
    double height_sign = 1.0;
};

class PidDriver final : public HidDriver {
  public:
    explicit PidDriver(const PidMapping& mapping = {}) : mapping_(mapping) {}

    [[nodiscard]] DeviceCapabilities capabilities() const override;
    // Reset, actuators on, then each effect: created, loaded, set, started with no force.
    Result<void> start(const HidDeviceInfo& device, HidPort& port) override;
    void take_report(std::span<const std::uint8_t> report, std::int64_t now_ns) noexcept override;
    [[nodiscard]] DeviceInput input(std::int64_t now_ns) const noexcept override;
    Result<void> send(HidPort& port, const ForceOrder& order, std::int64_t now_ns) override;
    void stop(HidPort& port) noexcept override;

  private:
    // One effect in the device, and what it was told last: equal reports are not sent twice.
    struct Effect {
        PidUsage type = PidUsage::kConstantForceType;
        Axis axis = Axis::kX;  // of a constant force
        std::uint8_t block = 0;
        std::optional<Report> told_x = std::nullopt;
        std::optional<Report> told_y = std::nullopt;
    };

    Result<void> begin(HidPort& port);
    // None: the device has no room for it.
    Result<std::optional<Effect>> load(HidPort& port, PidUsage type, Axis axis);
    [[nodiscard]] bool can_show_a_wall() const noexcept;
    Result<void> start_effects(HidPort& port);
    Result<void> tell(HidPort& port, Effect& effect, const ForceOrder& order);
    [[nodiscard]] PidCondition wall_condition(const ForceOrder& order) const noexcept;
    [[nodiscard]] double fraction_of_force(double force_n) const noexcept;
    [[nodiscard]] double mm_per_unit() const noexcept {
        return (mapping_.reach.most_radius_mm - mapping_.reach.least_radius_mm) / 2.0;
    }
    // Of the wall it shows at the most: a weak stick cannot be as stiff as wanted.
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
    bool is_stopped_ = false;  // by starvation
    bool is_started_ = false;  // last_start_ns_ and last_told_ns_ mean something
};

}  // namespace onggi::haptics::hid

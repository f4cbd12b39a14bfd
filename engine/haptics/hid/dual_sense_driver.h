// Driver of the DualSense over USB. I/O thread. The left stick moves the tool (rate control), the right
// trigger presses it inwards and meets the clay's resistance, L2 or cross turn the wheel. Never tried on
// hardware by this project: newtons stand for shares of a trigger's strongest resistance, which its maker
// does not tell.
#pragma once

#include <optional>

#include "engine/haptics/hid/dual_sense.h"
#include "engine/haptics/hid/hid_driver.h"
#include "engine/haptics/hid/local_wall.h"

namespace onggi::haptics::hid {

struct DualSenseMapping {
    double fastest_mm_s = 120.0;
    double stick_dead_band = 0.08;  // of full deflection
    double press_mm = 20.0;         // the right trigger pulled all the way
    double stiffness_n_per_mm = 0.5;
    double strongest_n = 3.3;  // the force that is shown as the trigger's strongest zone
};

// The trigger's resistance where the clay would push with F(x) at the travel x: each zone's centre,
// quantised. `press_mm`: how far the trigger has the tool pressed in as the order was worked out.
[[nodiscard]] TriggerEffect trigger_for_wall(const ForceOrder& order, double press_mm,
                                             const DualSenseMapping& mapping) noexcept;

class DualSenseDriver final : public HidDriver {
  public:
    explicit DualSenseDriver(const DualSenseMapping& mapping = {}) : mapping_(mapping) {}

    [[nodiscard]] DeviceCapabilities capabilities() const override;
    Result<void> start(const HidDeviceInfo& device, HidPort& port) override;
    void take_report(std::span<const std::uint8_t> report, std::int64_t now_ns) noexcept override;
    [[nodiscard]] HandInput input(std::int64_t now_ns) const noexcept override;
    Result<void> send(HidPort& port, const ForceOrder& order, std::int64_t now_ns) override;
    void stop(HidPort& port) noexcept override;

  private:
    [[nodiscard]] double press_mm() const noexcept;

    DualSenseMapping mapping_;
    DualSenseState state_;
    bool wheel_turns_ = false;
    std::int64_t heard_ns_ = 0;
    bool was_heard_ = false;
    std::optional<Report> last_sent_;
    std::int64_t last_sent_ns_ = 0;
};

}  // namespace onggi::haptics::hid

// Driver of the DualSense over USB and Bluetooth. I/O thread. The left stick moves the tool (rate control);
// so do a finger on the touch pad, and tilting the pad while L1 is held. The right trigger presses the tool
// inwards against the work's resistance: as stiff as the work is there, no stronger than a thin wall bears.
// L2 turns the wheel, the faster the further it is pulled; cross keeps it turning. The pad vibrates with the
// sliding wall, and its light shows how close the work is to yielding. Never tried on hardware by this
// project: newtons stand for fractions of a trigger's strongest resistance, which the maker does not state.
#pragma once

#include <optional>

#include "engine/haptics/hid/device_input.h"
#include "engine/haptics/hid/dual_sense.h"
#include "engine/haptics/hid/hid_driver.h"
#include "engine/haptics/safety_chain.h"

namespace onggi::haptics::hid {

struct DualSenseMapping {
    double fastest_mm_s = 120.0;
    double stick_dead_band = 0.08;  // of full deflection
    double press_mm = 20.0;         // the right trigger pulled all the way
    double stiffness_n_per_mm = 0.5;
    double strongest_n = kKioskPeakForceN;  // the force rendered as the trigger's strongest zone
    double most_stiffness_n_per_mm = 2.0;
    double touch_mm = 160.0;         // of the tool, for a finger moved across the whole touch pad
    double tilt_mm_per_deg = 1.5;    // of the tool, while L1 is held
    double tilt_dead_deg_s = 2.0;    // a pad at rest on a table reports this much
    double fastest_rev_min = 240.0;  // with L2 pulled all the way
};

// The trigger's resistance for a wall that pushes with F(x) at the travel x, sampled at each zone's centre
// and quantised. `press_mm`: how far the trigger pressed the tool in when the order was computed.
[[nodiscard]] TriggerEffect trigger_for_wall(const ForceOrder& order, double press_mm,
                                             const DualSenseMapping& mapping) noexcept;

// The light bar: shows the wheel's speed and how close the work is to yielding, from green through amber to
// red. Dark blue while the wheel stands. In coarse steps, and never flashing.
[[nodiscard]] std::array<std::uint8_t, 3> light_for(const ForceOrder& order) noexcept;

class DualSenseDriver final : public HidDriver {
  public:
    explicit DualSenseDriver(const DualSenseMapping& mapping = {}) : mapping_(mapping) {}

    [[nodiscard]] DeviceCapabilities capabilities() const override;
    Result<void> start(const HidDeviceInfo& device, HidPort& port) override;
    void take_report(std::span<const std::uint8_t> report, std::int64_t now_ns) noexcept override;
    [[nodiscard]] DeviceInput input(std::int64_t now_ns) const noexcept override;
    Result<void> send(HidPort& port, const ForceOrder& order, std::int64_t now_ns) override;
    void stop(HidPort& port) noexcept override;

  private:
    [[nodiscard]] double press_mm() const noexcept;
    void travel(const DualSenseState& now) noexcept;
    // Sends the report in its USB or Bluetooth form.
    Result<void> tell(HidPort& port, const Report& report);

    DualSenseMapping mapping_;
    DualSenseState state_;
    dvec2 travelled_mm_{0.0};
    bool wheel_turns_ = false;
    std::int64_t heard_ns_ = 0;
    bool was_heard_ = false;
    bool is_by_radio_ = false;
    unsigned sequence_ = 0;  // of Bluetooth reports
    std::optional<Report> last_sent_;
    std::int64_t last_sent_ns_ = 0;
};

}  // namespace onggi::haptics::hid

// Driver of the DualSense over USB and Bluetooth. I/O thread. The left stick moves the tool (rate control), a
// finger on the touch pad draws it, tilting the pad while L1 is held leads it. The right trigger presses it
// inwards and meets the work's resistance: as stiff as the work is there, no stronger than a thin wall bears.
// L2 turns the wheel, the faster the further it is pulled; cross keeps it turning. The pad trembles with the
// wall that slides by, and its light says how near the work is to giving way. Never tried on hardware by this
// project: newtons stand for shares of a trigger's strongest resistance, which its maker does not tell.
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
    double strongest_n = kKioskPeakForceN;  // the force that is shown as the trigger's strongest zone
    double most_stiffness_n_per_mm = 2.0;
    double touch_mm = 160.0;         // of the tool, for a finger drawn across the whole touch pad
    double tilt_mm_per_deg = 1.5;    // of the tool, while L1 is held
    double tilt_dead_deg_s = 2.0;    // a pad on a table says as much
    double fastest_rev_min = 240.0;  // with L2 pulled all the way
};

// The trigger's resistance where the work would push with F(x) at the travel x: each zone's centre,
// quantised. `press_mm`: how far the trigger has the tool pressed in as the order was worked out.
[[nodiscard]] TriggerEffect trigger_for_wall(const ForceOrder& order, double press_mm,
                                             const DualSenseMapping& mapping) noexcept;

// The light bar: how fast the work turns and how near it is to giving way, from green by amber to red. Dark
// blue while the wheel stands. In coarse steps, and never flashing.
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
    // In the form of the way it is connected.
    Result<void> tell(HidPort& port, const Report& report);

    DualSenseMapping mapping_;
    DualSenseState state_;
    dvec2 travelled_mm_{0.0};
    bool wheel_turns_ = false;
    std::int64_t heard_ns_ = 0;
    bool was_heard_ = false;
    bool is_by_radio_ = false;
    unsigned sequence_ = 0;  // of reports by radio
    std::optional<Report> last_sent_;
    std::int64_t last_sent_ns_ = 0;
};

}  // namespace onggi::haptics::hid

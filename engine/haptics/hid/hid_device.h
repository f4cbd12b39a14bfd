// A real device on the USB bus, as the rest of the program sees any device: a HapticDevice. It may be plugged
// in and out at any time; meanwhile the tool stays where it is, without force.
//
//     auto device = make_hid_device({.kind = HidKind::kForceJoystick});   // main thread
//     device->open();                          // starts its I/O thread, which looks for it from now on
//     ... the haptic thread reads and writes, the main thread asks status() ...
//     device->close();                         // forces off, thread ended
//
// read() and write() touch mailboxes only: no call into hidapi, no lock, no allocation. All that blocks
// happens on the I/O thread (hid_session.h).
#pragma once

#include <cstdint>
#include <memory>

#include "engine/haptics/haptic_device.h"
#include "engine/haptics/hid/dual_sense_driver.h"
#include "engine/haptics/hid/hid_kind.h"
#include "engine/haptics/hid/hid_session.h"
#include "engine/haptics/hid/pid_driver.h"
#include "engine/haptics/hid/simple_drivers.h"
#include "engine/haptics/hid/tool_mover.h"

namespace onggi::haptics {

struct HidDeviceOptions {
    HidKind kind = HidKind::kUnknown;
    hid::ToolReach reach = {};
    hid::SpaceMouseMapping space_mouse = {};
    hid::DualSenseMapping dual_sense = {};
    hid::PidMapping joystick = {};  // its reach is taken from above
};

class HidDevice final : public HapticDevice {
  public:
    HidDevice(const HidDeviceOptions& options, std::unique_ptr<hid::HidBus> bus);
    ~HidDevice() override { close(); }

    // Never waits for the device: one that is not there yet is found when it comes. Error: no thread.
    Result<void> open() override;
    // Waits for the I/O thread's round, some ms as a rule; leaves the device without force.
    void close() noexcept override;
    [[nodiscard]] DeviceCapabilities capabilities() const override { return capabilities_; }

    [[nodiscard]] ToolState read(std::uint64_t tick, double dt_s) noexcept override;
    void write(const dvec3& force_n) noexcept override;

    // Main thread, any time.
    [[nodiscard]] const hid::HidStatus& status() noexcept { return link_.status.latest(); }
    [[nodiscard]] HidKind kind() const noexcept { return kind_; }

  private:
    HidKind kind_;
    DeviceCapabilities capabilities_;
    hid::HidLink link_;
    hid::HidSession session_;
    jobs::IoThread thread_;
    // Haptic thread only.
    hid::ToolMover mover_;
    ToolState tool_;
    std::uint64_t ticks_ = 0;
};

// With the real bus, hidapi's. Null for kUnknown.
[[nodiscard]] std::unique_ptr<HidDevice> make_hid_device(const HidDeviceOptions& options);

// A tool held in one hand and a pedal for the wheel: either's button turns it. Neither is owned.
class PedalledDevice final : public HapticDevice {
  public:
    PedalledDevice(HapticDevice& tool, HapticDevice& pedal) : tool_(tool), pedal_(pedal) {}

    // Opens both. A pedal that cannot be opened is no reason to refuse the tool's.
    Result<void> open() override;
    void close() noexcept override;
    [[nodiscard]] DeviceCapabilities capabilities() const override { return tool_.capabilities(); }
    [[nodiscard]] ToolState read(std::uint64_t tick, double dt_s) noexcept override;
    void write(const dvec3& force_n) noexcept override { tool_.write(force_n); }

  private:
    HapticDevice& tool_;
    HapticDevice& pedal_;
};

}  // namespace onggi::haptics

// What one kind of device is to its I/O thread: how it is begun, heard, told and left in peace. The drivers
// know bytes and mm; who calls them, when, and what happens when a device goes away is hid_session.h's
// affair.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "engine/haptics/haptic_device.h"
#include "engine/haptics/hid/device_input.h"
#include "engine/haptics/hid/hid_port.h"

namespace onggi::haptics::hid {

class HidDriver {
  public:
    virtual ~HidDriver() = default;

    // Any thread; what does not depend on whether one is plugged in.
    [[nodiscard]] virtual DeviceCapabilities capabilities() const = 0;

    // The rest: the I/O thread. start: a device has just been opened; what an earlier one left is forgotten.
    // Error: it cannot be used, and stop() has been called.
    virtual Result<void> start(const HidDeviceInfo& device, HidPort& port) = 0;
    // Every report, in order.
    virtual void take_report(std::span<const std::uint8_t> report, std::int64_t now_ns) noexcept = 0;
    // What all the reports so far say of the hand. is_live false: silent for longer than this device ever is.
    [[nodiscard]] virtual DeviceInput input(std::int64_t now_ns) const noexcept = 0;
    // Tells the device, where something has changed or is due. The force has passed every limit. An error:
    // the device is gone.
    virtual Result<void> send(HidPort& port, const ForceOrder& order, std::int64_t now_ns) = 0;
    // All forces off, whatever happens; the device may be gone already.
    virtual void stop(HidPort& port) noexcept = 0;
};

constexpr std::int64_t kMs = 1'000'000;  // ns

}  // namespace onggi::haptics::hid

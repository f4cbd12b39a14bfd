// The driver of one kind of device, used by its I/O thread: start, reports in, forces out, stop. Drivers
// translate between bytes and mm; hid_session.h decides when to call them and handles removal.
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

    // Any thread; independent of whether a device is plugged in.
    [[nodiscard]] virtual DeviceCapabilities capabilities() const = 0;

    // All others: the I/O thread. start: a device has just been opened; resets the driver's state. Error: the
    // device cannot be used, and stop() has been called.
    virtual Result<void> start(const HidDeviceInfo& device, HidPort& port) = 0;
    // Called for every report, in order.
    virtual void take_report(std::span<const std::uint8_t> report, std::int64_t now_ns) noexcept = 0;
    // The hand's input after all reports so far. is_live is false if the device has been silent for longer
    // than a working one would be.
    [[nodiscard]] virtual DeviceInput input(std::int64_t now_ns) const noexcept = 0;
    // Whether a hand moved between two reports of the same id and size of any device of the kind; `before` is
    // empty for the first. The default takes every report for a hand's.
    [[nodiscard]] virtual bool has_moved(std::span<const std::uint8_t> /*before*/,
                                         std::span<const std::uint8_t> /*now*/) const noexcept {
        return true;
    }
    // Sends what has changed or is due. The force has passed all limits. Error: the device is gone.
    virtual Result<void> send(HidPort& port, const ForceOrder& order, std::int64_t now_ns) = 0;
    // Turns all forces off; ignores errors, since the device may be gone.
    virtual void stop(HidPort& port) noexcept = 0;
};

constexpr std::int64_t kMs = 1'000'000;  // ns

}  // namespace onggi::haptics::hid

// Interfaces to HID devices: a bus that lists and opens them, and a port, which is one opened device. The
// real ones are in hidapi_bus.h; tests have scripted ones. Called from one device's I/O thread; both may
// block and allocate, so never from the tick.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/haptics/hid/hid_list.h"

namespace onggi::haptics::hid {

constexpr std::size_t kUsbReportBytes = 64;  // the maximum over full-speed USB
constexpr std::size_t kMaxReportBytes = 78;  // the longest report used here: a DualSense's over Bluetooth

// A report in a fixed buffer.
struct Report {
    std::array<std::uint8_t, kMaxReportBytes> bytes{};
    std::size_t size = 0;

    [[nodiscard]] std::span<const std::uint8_t> view() const noexcept { return {bytes.data(), size}; }
    friend bool operator==(const Report& a, const Report& b) noexcept {
        return std::equal(a.view().begin(), a.view().end(), b.view().begin(), b.view().end());
    }
};

class HidPort {
  public:
    virtual ~HidPort() = default;  // closes the device

    // Reads the next report in the device's queue, oldest first; byte 0 is the report's id if the device
    // numbers its reports. Waits up to timeout_ms; 0: does not wait. Returns its size, 0 if none came. Error:
    // the device is gone.
    virtual Result<std::size_t> read(std::span<std::uint8_t> report, int timeout_ms) = 0;
    // Byte 0 is the report's id, 0 if reports are not numbered. Error: the device is gone, or refused it.
    virtual Result<void> write(std::span<const std::uint8_t> report) = 0;
    virtual Result<void> set_feature(std::span<const std::uint8_t> report) = 0;
    // Byte 0 is the id of the wanted report; the report overwrites the buffer. Returns its size.
    virtual Result<std::size_t> get_feature(std::span<std::uint8_t> report) = 0;
    // Whether the device's node still exists: detects a removal without reading or writing.
    [[nodiscard]] virtual bool is_there() = 0;
    virtual void pause_ms(int milliseconds) = 0;
};

class HidBus {
  public:
    virtual ~HidBus() = default;

    virtual Result<std::vector<HidDeviceInfo>> list() = 0;
    virtual Result<std::unique_ptr<HidPort>> open(const HidDeviceInfo& device) = 0;
};

}  // namespace onggi::haptics::hid

// A real USB device as a HapticDevice. It may be plugged in and out at any time; while it is absent the tool
// stays in place without force.
//
//     auto device = make_hid_device({.kind = HidKind::kForceJoystick});   // main thread
//     device->open();                          // starts its I/O thread, which searches for it
//     ... the haptic thread reads and writes, the main thread asks status() ...
//     device->close();                         // forces off, thread stopped
//
// read() and write() touch mailboxes only: no call into hidapi, no lock, no allocation. All that blocks
// happens on the I/O thread (hid_session.h).
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "engine/haptics/haptic_device.h"
#include "engine/haptics/hid/dual_sense_driver.h"
#include "engine/haptics/hid/hid_kind.h"
#include "engine/haptics/hid/hid_session.h"
#include "engine/haptics/hid/pid_driver.h"
#include "engine/haptics/hid/simple_drivers.h"
#include "engine/haptics/hid/tool_tracker.h"

namespace onggi::haptics {

struct HidDeviceOptions {
    HidKind kind = HidKind::kUnknown;
    hid::ToolReach reach = {};
    hid::SpaceMouseMapping space_mouse = {};
    hid::DualSenseMapping dual_sense = {};
    hid::PidMapping joystick = {};  // its reach is taken from above
    std::string only = {};          // use only this node (/dev/hidrawN); empty: any of its kind
};

class HidDevice final : public HapticDevice {
  public:
    HidDevice(const HidDeviceOptions& options, std::unique_ptr<hid::HidBus> bus);
    ~HidDevice() override { close(); }

    // Does not wait for the device, which may be plugged in later. Error: the thread cannot start.
    Result<void> open() override;
    // Waits for the I/O thread's round, usually some ms; leaves the device without force.
    void close() noexcept override;
    [[nodiscard]] DeviceCapabilities capabilities() const override { return capabilities_; }

    [[nodiscard]] HandSample read(std::uint64_t tick, double dt_s) noexcept override;
    [[nodiscard]] DeviceSigns signs() const noexcept override {
        return {.position_is_new = tracker_.was_refreshed(),
                .hand_is_there = tracker_.input_is_live(),
                .shows_wall = shows_wall_,
                .force_fraction = force_fraction_};
    }
    void write(const dvec3& force_n) noexcept override;
    void silence() noexcept override { link_.silences.fetch_add(1, std::memory_order_relaxed); }
    void feel(const WorkFelt& work) noexcept override { work_ = work; }

    [[nodiscard]] bool is_here() const noexcept override { return tracker_.input_is_live(); }
    [[nodiscard]] bool is_moving() const noexcept override { return tracker_.hand_moves(); }
    [[nodiscard]] bool lives() const noexcept override { return tracker_.hand_lives(); }
    [[nodiscard]] bool never_rests() const noexcept override { return tracker_.never_rests(); }
    void take_over(const dvec3& position_mm) noexcept override { tracker_.put_at(position_mm); }

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
    hid::ToolTracker tracker_;
    HandSample sample_;
    double force_fraction_ = 0.0;
    WorkFelt work_;
    bool shows_wall_ = false;
    std::uint64_t ticks_ = 0;
};

// Stops the force of every plugged-in device, whichever process set it: for the supervisor of a program that
// has died. Opens, stops and closes each device; may take some 100 ms. Returns the number of devices stopped.
int let_go_of_all(hid::HidBus& bus);
int let_go_of_all();  // on the real bus

// With the real bus, hidapi's. Null for kUnknown.
[[nodiscard]] std::unique_ptr<HidDevice> make_hid_device(const HidDeviceOptions& options);

}  // namespace onggi::haptics

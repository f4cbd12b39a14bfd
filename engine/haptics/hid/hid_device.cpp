#include "engine/haptics/hid/hid_device.h"

#include <string>
#include <utility>

#include "engine/haptics/hid/hidapi_bus.h"

namespace onggi::haptics {
namespace {

std::unique_ptr<hid::HidDriver> driver_for(const HidDeviceOptions& options) {
    switch (options.kind) {
        case HidKind::kForceJoystick: {
            hid::PidMapping mapping = options.joystick;
            mapping.reach = options.reach;
            return std::make_unique<hid::PidDriver>(mapping);
        }
        case HidKind::kSpaceMouse:
            return std::make_unique<hid::SpaceMouseDriver>(options.space_mouse);
        case HidKind::kDualSense:
            return std::make_unique<hid::DualSenseDriver>(options.dual_sense);
        case HidKind::kVecPedal:
        case HidKind::kUnknown:
            break;
    }
    return std::make_unique<hid::VecPedalDriver>();
}

// At most 15 letters.
std::string thread_name(HidKind kind) {
    switch (kind) {
        case HidKind::kForceJoystick:
            return "onggi-joystick";
        case HidKind::kSpaceMouse:
            return "onggi-spacemous";
        case HidKind::kDualSense:
            return "onggi-dualsense";
        case HidKind::kVecPedal:
        case HidKind::kUnknown:
            break;
    }
    return "onggi-pedal";
}

}  // namespace

HidDevice::HidDevice(const HidDeviceOptions& options, std::unique_ptr<hid::HidBus> bus)
    : kind_(options.kind),
      capabilities_(driver_for(options)->capabilities()),
      session_(link_, std::move(bus), driver_for(options),
               {.kind = options.kind,
                .force = {.peak_n = capabilities_.force_axes > 0 ? capabilities_.peak_force_n : 0.0}}),
      mover_(options.reach) {}

Result<void> HidDevice::open() {
    if (thread_.running()) return {};
    return thread_.start(session_, thread_name(kind_));
}

void HidDevice::close() noexcept {
    thread_.stop();
}

ToolState HidDevice::read(std::uint64_t /*tick*/, double dt_s) noexcept {
    tool_ = mover_.moved(link_.input.latest(), dt_s);
    return tool_;
}

void HidDevice::write(const dvec3& force_n) noexcept {
    link_.force.put({.force_n = {force_n.x, force_n.y},
                     .tangential_n = force_n.z,
                     .tool_mm = {tool_.position_mm.x, tool_.position_mm.y},
                     .wheel_turns = tool_.wheel_button,
                     .ticks = ++ticks_});
}

std::unique_ptr<HidDevice> make_hid_device(const HidDeviceOptions& options) {
    if (options.kind == HidKind::kUnknown) return nullptr;
    return std::make_unique<HidDevice>(options, hid::make_hidapi_bus());
}

Result<void> PedalledDevice::open() {
    (void)pedal_.open();
    return tool_.open();
}

void PedalledDevice::close() noexcept {
    tool_.close();
    pedal_.close();
}

ToolState PedalledDevice::read(std::uint64_t tick, double dt_s) noexcept {
    const bool pedal_is_down = pedal_.read(tick, dt_s).wheel_button;
    ToolState tool = tool_.read(tick, dt_s);
    tool.wheel_button = tool.wheel_button || pedal_is_down;
    return tool;
}

}  // namespace onggi::haptics

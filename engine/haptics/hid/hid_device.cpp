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
                .only = options.only,
                .force = {.peak_n = capabilities_.force_axes > 0 ? capabilities_.peak_force_n : 0.0}}),
      tracker_(options.reach) {
    // The I/O thread's round, writes included, limits the rate of new values in its mailbox.
    constexpr double kRoundsPerS = 100.0;
    capabilities_.report_rate_hz = kRoundsPerS;
}

Result<void> HidDevice::open() {
    if (thread_.running()) return {};
    return thread_.start(session_, thread_name(kind_));
}

void HidDevice::close() noexcept {
    thread_.stop();
}

HandSample HidDevice::read(std::uint64_t /*tick*/, double dt_s) noexcept {
    const hid::DeviceInput& input = link_.input.latest();
    shows_wall_ = input.shows_wall;
    force_fraction_ = input.force_fraction;
    return sample_ = tracker_.moved(input, dt_s);
}

void HidDevice::write(const dvec3& force_n) noexcept {
    link_.force.put({.force_n = {force_n.x, force_n.y},
                     .tangential_n = force_n.z,
                     .tool_mm = {sample_.position_mm.x, sample_.position_mm.y},
                     .turns = sample_.button,
                     .work = work_,
                     .ticks = ++ticks_});
}

int let_go_of_all(hid::HidBus& bus) {
    const auto devices = bus.list();
    if (!devices) return 0;
    int count = 0;
    for (const HidDeviceInfo& info : *devices) {
        if (info.kind == HidKind::kUnknown || !info.refusal.empty()) continue;
        const auto driver = driver_for({.kind = info.kind});
        if (driver->capabilities().force_axes == 0) continue;
        auto port = bus.open(info);
        if (!port) continue;
        // start() identifies the device and stops its earlier effects.
        if (driver->start(info, **port)) ++count;
        driver->stop(**port);
    }
    return count;
}

int let_go_of_all() {
    const auto bus = hid::make_hidapi_bus();
    return let_go_of_all(*bus);
}

std::unique_ptr<HidDevice> make_hid_device(const HidDeviceOptions& options) {
    if (options.kind == HidKind::kUnknown) return nullptr;
    return std::make_unique<HidDevice>(options, hid::make_hidapi_bus());
}

}  // namespace onggi::haptics

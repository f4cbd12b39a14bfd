#include "engine/haptics/hid/hid_list.h"

#include <fmt/format.h>
#include <hidapi/hidapi.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "engine/files/read_file.h"
#include "engine/haptics/hid/hid_kind.h"
#include "engine/haptics/hid/hidapi_bus.h"
#include "engine/haptics/hid/report_descriptor.h"

namespace onggi::haptics {
namespace {

std::string name_of(const hid_device_info& device) {
    const std::string maker = hid::utf8_from(device.manufacturer_string);
    const std::string product = hid::utf8_from(device.product_string);
    if (maker.empty() || product.starts_with(maker)) return product;
    return maker + " " + product;
}

HidBusType bus_of(const hid_device_info& device) {
    switch (device.bus_type) {
        case HID_API_BUS_USB:
            return HidBusType::kUsb;
        case HID_API_BUS_BLUETOOTH:
            return HidBusType::kBluetooth;
        case HID_API_BUS_UNKNOWN:
            return HidBusType::kUnknown;
        default:
            return HidBusType::kOther;
    }
}

// hidapi returns descriptors from 0.14 on; the kernel's sysfs always has them.
std::vector<std::uint8_t> report_descriptor_of(const std::string& path) {
    const auto bytes = files::read_file(fmt::format("/sys/class/hidraw/{}/device/report_descriptor",
                                                    std::filesystem::path(path).filename().string()),
                                        hid::kMaxDescriptorBytes);
    if (!bytes) return {};
    return {bytes->begin(), bytes->end()};
}

}  // namespace

Result<std::vector<HidDeviceInfo>> list_hid_devices() {
    if (auto started = hid::start_hidapi(); !started) return started.error();
    std::vector<HidDeviceInfo> devices;
    {
        const hid::HidapiTurn turn;
        const std::unique_ptr<hid_device_info, decltype(&hid_free_enumeration)> list(hid_enumerate(0, 0),
                                                                                     &hid_free_enumeration);
        for (const hid_device_info* device = list.get(); device != nullptr; device = device->next) {
            devices.push_back({.path = device->path,
                               .name = name_of(*device),
                               .vendor_id = device->vendor_id,
                               .product_id = device->product_id,
                               .may_open = access(device->path, R_OK | W_OK) == 0,
                               .bus = bus_of(*device)});
        }
    }
    std::sort(devices.begin(), devices.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
    const auto same_path = [](const auto& a, const auto& b) { return a.path == b.path; };
    devices.erase(std::unique(devices.begin(), devices.end(), same_path), devices.end());
    for (HidDeviceInfo& device : devices) {
        device.report_descriptor = report_descriptor_of(device.path);
        hid::recognise(device);
    }
    return devices;
}

}  // namespace onggi::haptics

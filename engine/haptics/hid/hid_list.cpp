#include "engine/haptics/hid/hid_list.h"

#include <hidapi/hidapi.h>
#include <unistd.h>

#include <algorithm>
#include <memory>

namespace onggi::haptics {
namespace {

// Device strings are UTF-16 in the descriptor and wchar_t in hidapi; they go on as UTF-8. What is no
// character is left out, so that a broken device cannot break a terminal.
std::string utf8_from(const wchar_t* wide) {
    std::string text;
    for (; wide != nullptr && *wide != L'\0'; ++wide) {
        const auto point = static_cast<std::uint32_t>(*wide);
        const bool is_control = point < 0x20 || (point >= 0x7f && point < 0xa0);
        const bool is_surrogate = point >= 0xd800 && point < 0xe000;
        if (is_control || is_surrogate || point > 0x10ffff) continue;
        const auto continuation = [&](unsigned shift) {
            text.push_back(static_cast<char>(0x80U | ((point >> shift) & 0x3fU)));
        };
        if (point < 0x80) {
            text.push_back(static_cast<char>(point));
        } else if (point < 0x800) {
            text.push_back(static_cast<char>(0xc0U | (point >> 6U)));
            continuation(0);
        } else if (point < 0x10000) {
            text.push_back(static_cast<char>(0xe0U | (point >> 12U)));
            continuation(6);
            continuation(0);
        } else {
            text.push_back(static_cast<char>(0xf0U | (point >> 18U)));
            continuation(12);
            continuation(6);
            continuation(0);
        }
    }
    return text;
}

std::string name_of(const hid_device_info& device) {
    const std::string maker = utf8_from(device.manufacturer_string);
    const std::string product = utf8_from(device.product_string);
    if (maker.empty() || product.starts_with(maker)) return product;
    return maker + " " + product;
}

}  // namespace

Result<std::vector<HidDeviceInfo>> list_hid_devices() {
    if (hid_init() != 0)
        return system_lacks("hidapi: expected to start, found no access to the system's HID devices");
    std::vector<HidDeviceInfo> devices;
    {
        const std::unique_ptr<hid_device_info, decltype(&hid_free_enumeration)> list(hid_enumerate(0, 0),
                                                                                     &hid_free_enumeration);
        for (const hid_device_info* device = list.get(); device != nullptr; device = device->next) {
            devices.push_back({.path = device->path,
                               .name = name_of(*device),
                               .vendor_id = device->vendor_id,
                               .product_id = device->product_id,
                               .may_open = access(device->path, R_OK | W_OK) == 0});
        }
    }
    hid_exit();
    std::sort(devices.begin(), devices.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
    const auto same_path = [](const auto& a, const auto& b) { return a.path == b.path; };
    devices.erase(std::unique(devices.begin(), devices.end(), same_path), devices.end());
    return devices;
}

}  // namespace onggi::haptics

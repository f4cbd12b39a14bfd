// Report descriptors of public devices, from tests/support/public_devices.tsv: what real hosts are given. For
// tests, any thread.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "engine/haptics/hid/hid_list.h"
#include "tests/support/hex.h"
#include "tests/support/places.h"

namespace onggi::testing {

struct PublicDevice {
    std::string name;
    haptics::HidDeviceInfo info;  // may be opened; not yet recognised
    std::string becomes;          // its kind here, "none", or "refused: " and the reason
};

// All rows, in the table's order. Fails the test if the table cannot be read.
inline std::vector<PublicDevice> public_devices() {
    const std::string path = test::in_checkout("tests/support/public_devices.tsv");
    std::ifstream table(path);
    std::vector<PublicDevice> devices;
    std::string line;
    std::getline(table, line);
    EXPECT_EQ(line, "name\tbus\tvendor:product\tsource\tbecomes\tdescriptor") << path;
    while (std::getline(table, line)) {
        std::istringstream cells(line);
        std::string bus;
        std::string numbers;
        std::string source;
        std::string descriptor;
        PublicDevice device;
        for (std::string* cell : {&device.name, &bus, &numbers, &source, &device.becomes, &descriptor})
            std::getline(cells, *cell, '\t');
        const std::vector<std::uint8_t> ids = hex(numbers.erase(4, 1));
        device.info.vendor_id = static_cast<std::uint16_t>(ids[0] << 8U | ids[1]);
        device.info.product_id = static_cast<std::uint16_t>(ids[2] << 8U | ids[3]);
        device.info.may_open = true;
        device.info.bus = bus == "0003"   ? haptics::HidBusType::kUsb
                          : bus == "0005" ? haptics::HidBusType::kBluetooth
                                          : haptics::HidBusType::kOther;
        device.info.report_descriptor = hex(descriptor);
        devices.push_back(std::move(device));
    }
    return devices;
}

// The only device whose name begins so.
inline PublicDevice public_device(std::string_view name) {
    PublicDevice found;
    int times = 0;
    for (PublicDevice& device : public_devices()) {
        if (!device.name.starts_with(name)) continue;
        ++times;
        found = std::move(device);
    }
    EXPECT_EQ(times, 1) << name;
    return found;
}

}  // namespace onggi::testing

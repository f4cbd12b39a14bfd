#include "tests/device/mock_hid.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <fstream>

#include "tests/support/hex.h"

namespace onggi::testing {
namespace {

constexpr std::string_view kUsbPath = "/devices/pci0000:00/0000:00:14.0/usb1";

std::string hid_id(const MockHid& device) {
    return fmt::format("{:04X}:{:04X}:{:04X}.{:04X}", device.is_bluetooth ? 5 : 3, device.vendor_id,
                       device.product_id, device.node);
}

std::string usb_path(const MockHid& device) {
    return fmt::format("{}/1-{}", kUsbPath, device.node + 1);
}
std::string interface_path(const MockHid& device) {
    return fmt::format("{}/1-{}:1.0", usb_path(device), device.node + 1);
}
std::string hid_path(const MockHid& device) {
    return interface_path(device) + "/" + hid_id(device);
}
std::string node_path(const MockHid& device) {
    return fmt::format("{}/hidraw/hidraw{}", hid_path(device), device.node);
}

std::string solid_hex(const std::vector<std::uint8_t>& bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes)
        text += fmt::format("{:02X}", byte);
    return text;
}

// umockdev's device description: USB device, interface, HID device, hidraw node; ended by empty lines.
std::string description(const MockHid& device) {
    std::string text = fmt::format(
        "P: {}\nE: DEVTYPE=usb_device\nE: DRIVER=usb\nE: PRODUCT={:x}/{:x}/100\nE: SUBSYSTEM=usb\n"
        "A: bcdDevice=0100\\n\nA: idProduct={:04x}\\n\nA: idVendor={:04x}\\n\nA: manufacturer={}\\n\nA: "
        "product={}\\n\n\n",
        usb_path(device), device.vendor_id, device.product_id, device.product_id, device.vendor_id,
        device.maker, device.product);
    text += fmt::format(
        "P: {}\nE: DEVTYPE=usb_interface\nE: DRIVER=usbhid\nE: SUBSYSTEM=usb\nA: bInterfaceNumber=00\\n\n\n",
        interface_path(device));
    text += fmt::format(
        "P: {}\nE: DRIVER=hid-generic\nE: HID_ID={:04X}:{:08X}:{:08X}\nE: HID_NAME={} {}\nE: "
        "HID_PHYS=mock/{}\n"
        "E: HID_UNIQ=\nE: SUBSYSTEM=hid\nH: report_descriptor={}\n\n",
        hid_path(device), device.is_bluetooth ? 5 : 3, device.vendor_id, device.product_id, device.maker,
        device.product, device.node, solid_hex(device.descriptor));
    text += fmt::format(
        "P: {}\nN: hidraw{}\nE: DEVNAME=/dev/hidraw{}\nE: MAJOR=240\nE: MINOR={}\nE: SUBSYSTEM=hidraw\n"
        "A: dev=240:{}\\n\nL: device=../../../{}\n\n",
        node_path(device), device.node, device.node, device.node, device.node, hid_id(device));
    return text;
}

// Escapes a byte below a space as ^ and the letter 64 above; the caret itself as ^`.
std::string escaped(std::string_view hex_bytes) {
    std::string text;
    for (const std::uint8_t byte : hex(hex_bytes)) {
        if (byte < 0x20) {
            text += '^';
            text += static_cast<char>(byte + 64);
        } else if (byte == '^') {
            text += "^`";
        } else {
            text += static_cast<char>(byte);
        }
    }
    return text;
}

// The kernel's ioctl answers for a hidraw node: the descriptor's size, and the descriptor in a 4096-byte
// buffer.
std::string descriptor_ioctls(const MockHid& device) {
    const auto size = static_cast<std::uint32_t>(device.descriptor.size());
    std::vector<std::uint8_t> little;
    for (unsigned byte = 0; byte < 4; ++byte)
        little.push_back(static_cast<std::uint8_t>(size >> (8 * byte)));
    std::vector<std::uint8_t> whole = little;
    whole.insert(whole.end(), device.descriptor.begin(), device.descriptor.end());
    whole.resize(4 + 4096);
    return fmt::format("HIDIOCGRDESCSIZE 0 {}\nHIDIOCGRDESC 0 {}\n", solid_hex(little), solid_hex(whole));
}

void expect_none(GError*& error) {
    if (error == nullptr) return;
    ADD_FAILURE() << error->message;
    g_clear_error(&error);
}

}  // namespace

HidScript& HidScript::reports(std::string_view hex_bytes, int after_ms) {
    lines_ += fmt::format("r {} {}\n", after_ms, escaped(hex_bytes));
    return *this;
}

HidScript& HidScript::expects(std::string_view hex_bytes) {
    lines_ += fmt::format("w 0 {}\n", escaped(hex_bytes));
    return *this;
}

HidScript& HidScript::sets_feature(std::string_view hex_bytes) {
    const auto bytes = hex(hex_bytes);
    ioctls_ += fmt::format("HIDIOCSFEATURE {} {}\n", bytes.size(), solid_hex(bytes));
    return *this;
}

HidScript& HidScript::answers_feature(std::string_view hex_bytes) {
    const auto bytes = hex(hex_bytes);
    ioctls_ += fmt::format("HIDIOCGFEATURE {} {}\n", bytes.size(), solid_hex(bytes));
    return *this;
}

void LiveHid::report(std::string_view hex_bytes) const {
    const auto bytes = hex(hex_bytes);
    if (write(file_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
        ADD_FAILURE() << "a device could not report";
}

std::string LiveHid::take_written() const {
    std::string text;
    pollfd waiting{file_, POLLIN, 0};
    std::array<std::uint8_t, 4096> bytes{};
    while (poll(&waiting, 1, 0) > 0 && (waiting.revents & POLLIN) != 0) {
        const ssize_t size = read(file_, bytes.data(), bytes.size());
        if (size <= 0) break;
        text += as_hex(std::span(bytes).first(static_cast<std::size_t>(size)));
    }
    std::erase(text, ' ');
    return text;
}

MockBus::MockBus() : testbed_(umockdev_testbed_new()) {}

MockBus::~MockBus() {
    g_object_unref(testbed_);
}

void MockBus::plug_in(const MockHid& device, const HidScript& script) {
    GError* error = nullptr;
    umockdev_testbed_add_from_string(testbed_, description(device).c_str(), &error);
    expect_none(error);
    const std::string ioctls = (folder_ / fmt::format("{}.ioctl", device.node)).string();
    std::ofstream(ioctls) << descriptor_ioctls(device) << script.ioctls();
    umockdev_testbed_load_ioctl(testbed_, device.path().c_str(), ioctls.c_str(), &error);
    expect_none(error);
    if (script.lines().empty()) return;
    const std::string lines = (folder_ / fmt::format("{}.script", device.node)).string();
    std::ofstream(lines, std::ios::binary) << "d 0 " << device.path() << "\n" << script.lines();
    umockdev_testbed_load_script(testbed_, device.path().c_str(), lines.c_str(), &error);
    expect_none(error);
}

LiveHid MockBus::at(const MockHid& device) {
    return LiveHid(umockdev_testbed_get_dev_fd(testbed_, device.path().c_str()));
}

void MockBus::forbid(const MockHid& device) {
    const std::string node = std::string(umockdev_testbed_get_root_dir(testbed_)) + device.path();
    if (chmod(node.c_str(), 0) != 0) ADD_FAILURE() << node << ": its permissions cannot be changed";
}

void MockBus::pull_out(const MockHid& device) {
    const std::vector<std::string> paths{node_path(device), hid_path(device), interface_path(device),
                                         usb_path(device)};
    for (const std::string& path : paths)
        umockdev_testbed_remove_device(testbed_, ("/sys" + path).c_str());
}

}  // namespace onggi::testing

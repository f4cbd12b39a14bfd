#include "tests/device/mock_gamepad.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <linux/input.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <span>
#include <vector>

namespace onggi::testing {
namespace {

constexpr std::array<std::uint16_t, 11> kButtons{
    BTN_A, BTN_B, BTN_X, BTN_Y, BTN_TL, BTN_TR, BTN_SELECT, BTN_START, BTN_MODE, BTN_THUMBL, BTN_THUMBR};
constexpr std::array<std::uint16_t, 8> kAxes{ABS_X,  ABS_Y,  ABS_Z,     ABS_RX,
                                             ABS_RY, ABS_RZ, ABS_HAT0X, ABS_HAT0Y};

std::vector<std::uint8_t> bits_of(std::span<const std::uint16_t> codes) {
    std::vector<std::uint8_t> bits(KEY_CNT / 8 + 1, 0);
    for (const std::uint16_t code : codes)
        bits[code / 8U] = static_cast<std::uint8_t>(bits[code / 8U] | (1U << (code % 8U)));
    return bits;
}

template <typename Struct>
std::vector<std::uint8_t> bytes_of(const Struct& value) {
    std::vector<std::uint8_t> bytes(sizeof value);
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
}

// The kernel's answer to an ioctl of type 'E' (<linux/input.h>); empty: unknown ioctl.
std::vector<std::uint8_t> answer_to(unsigned number, EventQueue& queue) {
    const GamepadIdentity& pad = queue.pad;
    constexpr unsigned kId = 0x02;
    constexpr unsigned kName = 0x06;
    constexpr unsigned kBits = 0x20;  // and the event type
    constexpr unsigned kAxis = 0x40;  // and the axis
    if (number == kId)
        return bytes_of(input_id{
            .bustype = pad.bus, .vendor = pad.vendor_id, .product = pad.product_id, .version = pad.version});
    if (number == kName) return {pad.name.c_str(), pad.name.c_str() + pad.name.size() + 1};
    if (number == kBits) return bits_of(std::array<std::uint16_t, 3>{EV_SYN, EV_KEY, EV_ABS});
    if (number == kBits + EV_KEY) return bits_of(kButtons);
    if (number == kBits + EV_ABS) return bits_of(kAxes);
    if (number >= kAxis && number < kAxis + ABS_CNT) {
        const auto axis = static_cast<std::uint16_t>(number - kAxis);
        if (std::find(kAxes.begin(), kAxes.end(), axis) == kAxes.end()) return {};
        input_absinfo info{};
        const bool is_trigger = axis == ABS_Z || axis == ABS_RZ;
        const bool is_hat = axis == ABS_HAT0X || axis == ABS_HAT0Y;
        const std::lock_guard lock(queue.lock);
        info.value = queue.axes[axis];
        info.minimum = is_trigger ? 0 : is_hat ? -1 : -32768;
        info.maximum = is_trigger ? 255 : is_hat ? 1 : 32767;
        return bytes_of(info);
    }
    return {};
}

// On umockdev's own thread.
gboolean on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer user) {
    auto& queue = *static_cast<EventQueue*>(user);
    const auto request = static_cast<unsigned long>(umockdev_ioctl_client_get_request(client));
    std::vector<std::uint8_t> answer;
    if (_IOC_TYPE(request) == 'E') answer = answer_to(_IOC_NR(request), queue);
    if (answer.empty()) {
        umockdev_ioctl_client_complete(client, -1, EINVAL);
        return TRUE;
    }
    answer.resize(std::min<std::size_t>(answer.size(), _IOC_SIZE(request)));
    GError* error = nullptr;
    UMockdevIoctlData* place =
        umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, _IOC_SIZE(request), &error);
    if (place != nullptr) {
        umockdev_ioctl_data_update(place, 0, answer.data(), static_cast<int>(answer.size()));
        g_object_unref(place);
    }
    const bool is_told = error == nullptr;
    g_clear_error(&error);
    umockdev_ioctl_client_complete(client, is_told ? static_cast<long>(answer.size()) : -1,
                                   is_told ? 0 : EFAULT);
    return TRUE;
}

// Returns the pending bytes, in whole events; if there are none, EAGAIN, as for a node opened with
// O_NONBLOCK.
gboolean on_read(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer user) {
    auto& queue = *static_cast<EventQueue*>(user);
    UMockdevIoctlData* place = umockdev_ioctl_client_get_arg(client);
    const std::lock_guard lock(queue.lock);
    const std::size_t room =
        static_cast<std::size_t>(place->data_len) / sizeof(input_event) * sizeof(input_event);
    const std::size_t size = std::min(room, queue.bytes.size());
    if (size == 0) {
        umockdev_ioctl_client_complete(client, -1, EAGAIN);
        return TRUE;
    }
    umockdev_ioctl_data_update(place, 0, queue.bytes.data(), static_cast<int>(size));
    queue.bytes.erase(queue.bytes.begin(), queue.bytes.begin() + static_cast<std::ptrdiff_t>(size));
    umockdev_ioctl_client_complete(client, static_cast<long>(size), 0);
    return TRUE;
}

}  // namespace

MockGamepad::MockGamepad(UMockdevTestbed* testbed, const GamepadIdentity& identity)
    : testbed_(testbed),
      sysfs_(fmt::format("/devices/pci0/usb1/input/input{0}/event{0}", identity.node)),
      answers_(umockdev_ioctl_base_new()) {
    queue_.pad = identity;
    const std::string node = fmt::format("/dev/input/event{}", identity.node);
    g_signal_connect(answers_, "handle-ioctl", G_CALLBACK(on_ioctl), &queue_);
    g_signal_connect(answers_, "handle-read", G_CALLBACK(on_read), &queue_);
    GError* error = nullptr;
    // Attach before the node is announced: a listener sends ioctls at once.
    umockdev_testbed_attach_ioctl(testbed_, node.c_str(), answers_, &error);
    if (error != nullptr) ADD_FAILURE() << error->message;
    g_clear_error(&error);
    const std::string device = fmt::format(
        "P: {0}\nN: input/event{1}\nE: DEVNAME=/dev/input/event{1}\nE: MAJOR=13\nE: MINOR={2}\n"
        "E: SUBSYSTEM=input\nA: dev=13:{2}\\n\n\n",
        sysfs_, identity.node, 64 + identity.node);
    umockdev_testbed_add_from_string(testbed_, device.c_str(), &error);
    if (error != nullptr) ADD_FAILURE() << error->message;
    g_clear_error(&error);
}

MockGamepad::~MockGamepad() {
    g_object_unref(answers_);
}

void MockGamepad::send(std::uint16_t type, std::uint16_t code, std::int32_t value) {
    std::array<input_event, 2> events{};
    events[0].type = type;
    events[0].code = code;
    events[0].value = value;
    events[1].type = EV_SYN;
    events[1].code = SYN_REPORT;
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(events.data());
    const std::lock_guard lock(queue_.lock);
    if (type == EV_ABS) queue_.axes[code] = value;
    queue_.bytes.insert(queue_.bytes.end(), bytes, bytes + sizeof events);
}

void MockGamepad::press(std::uint16_t button, bool pressed) {
    send(EV_KEY, button, pressed ? 1 : 0);
}

void MockGamepad::move(std::uint16_t axis, std::int32_t value) {
    send(EV_ABS, axis, value);
}

void MockGamepad::pull_out() {
    umockdev_testbed_remove_device(testbed_, ("/sys" + sysfs_).c_str());
}

}  // namespace onggi::testing

#include "engine/haptics/hid/hid_kind.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/haptics/hid/pid_layout.h"
#include "engine/haptics/hid/report_descriptor.h"

namespace onggi::haptics::hid {
namespace {

constexpr std::uint16_t k3Dconnexion = 0x256f;
constexpr Usage kMouse = usage(0x01, 0x02);
constexpr Usage kKeyboard = usage(0x01, 0x06);
constexpr Usage kMultiAxisController = usage(0x01, 0x08);
constexpr std::uint16_t kForcePage = 0x0f;

constexpr std::array<KnownDevice, 32> kKnownDevices{{
    // Logitech sold the early models; its vendor number alone could be any mouse.
    {0x046d, 0xc603, HidKind::kSpaceMouse},  // SpaceMouse Plus XT
    {0x046d, 0xc605, HidKind::kSpaceMouse},  // CadMan
    {0x046d, 0xc606, HidKind::kSpaceMouse},  // SpaceMouse Classic
    {0x046d, 0xc621, HidKind::kSpaceMouse},  // Spaceball 5000
    {0x046d, 0xc623, HidKind::kSpaceMouse},  // SpaceTraveller
    {0x046d, 0xc625, HidKind::kSpaceMouse},  // SpacePilot
    {0x046d, 0xc626, HidKind::kSpaceMouse},  // SpaceNavigator
    {0x046d, 0xc627, HidKind::kSpaceMouse},  // SpaceExplorer
    {0x046d, 0xc628, HidKind::kSpaceMouse},  // SpaceNavigator for Notebooks
    {0x046d, 0xc629, HidKind::kSpaceMouse},  // SpacePilot Pro
    {0x046d, 0xc62b, HidKind::kSpaceMouse},  // SpaceMouse Pro
    {0x046d, 0xc640, HidKind::kSpaceMouse},  // NuLOOQ
    {0x256f, 0xc62e, HidKind::kSpaceMouse},  // SpaceMouse Wireless, cable
    {0x256f, 0xc62f, HidKind::kSpaceMouse},  // SpaceMouse Wireless, receiver
    {0x256f, 0xc63a, HidKind::kSpaceMouse},  // SpaceMouse Wireless, BT and USB
    {0x256f, 0xc631, HidKind::kSpaceMouse},  // SpaceMouse Pro Wireless, cable
    {0x256f, 0xc632, HidKind::kSpaceMouse},  // SpaceMouse Pro Wireless, receiver
    {0x256f, 0xc638, HidKind::kSpaceMouse},  // SpaceMouse Pro Wireless, BT and USB
    {0x256f, 0xc633, HidKind::kSpaceMouse},  // SpaceMouse Enterprise
    {0x256f, 0xc635, HidKind::kSpaceMouse},  // SpaceMouse Compact
    {0x256f, 0xc636, HidKind::kSpaceMouse},  // SpaceMouse Module
    {0x256f, 0xc641, HidKind::kSpaceMouse},  // Scout
    {0x256f, 0xc652, HidKind::kSpaceMouse},  // Universal Receiver
    {0x054c, 0x0ce6, HidKind::kDualSense},     {0x054c, 0x0df2, HidKind::kDualSense},  // DualSense Edge
    {0x05f3, 0x00ff, HidKind::kVecPedal},                                              // Infinity
    {0x1209, 0xffb0, HidKind::kForceJoystick},                                         // OpenFFBoard
    {0x045b, 0x58f9, HidKind::kForceJoystick},                                         // FFBeast
    {0xffff, 0x2055, HidKind::kForceJoystick},                                         // VPforce Rhino
    {0x346e, 0x1000, HidKind::kForceJoystick},                                         // Moza AB9
    {0x346e, 0x1002, HidKind::kForceJoystick},                                         // Moza AB6
    {0x045e, 0x001b, HidKind::kForceJoystick},  // SideWinder Force Feedback 2
}};
// Mice and keyboards of the same maker.
constexpr std::array<std::uint16_t, 11> kNotSpaceMice{0xc650, 0xc651, 0xc654, 0xc655, 0xc656, 0xc657,
                                                      0xc658, 0xc664, 0xc668, 0xc665, 0xc62c};

HidKind kind_by_number(const HidDeviceInfo& device) {
    const auto known =
        std::find_if(kKnownDevices.begin(), kKnownDevices.end(), [&](const KnownDevice& entry) {
            return entry.vendor_id == device.vendor_id && entry.product_id == device.product_id;
        });
    return known == kKnownDevices.end() ? HidKind::kUnknown : known->kind;
}

bool takes_forces(const ReportDescriptor& descriptor) {
    return std::any_of(descriptor.fields().begin(), descriptor.fields().end(), [](const Field& field) {
        return field.kind == ReportKind::kOutput && !field.usages.empty() &&
               field.usages.front().first >> 16U == kForcePage;
    });
}

bool has_collection(const ReportDescriptor& descriptor, Usage wanted) {
    return std::any_of(descriptor.collections().begin(), descriptor.collections().end(),
                       [&](const Collection& collection) { return collection.usage == wanted; });
}

// Whether the descriptor is that of a SpaceMouse newer than the list.
bool is_newer_space_mouse(const HidDeviceInfo& device, const ReportDescriptor& descriptor) {
    const bool is_another =
        std::find(kNotSpaceMice.begin(), kNotSpaceMice.end(), device.product_id) != kNotSpaceMice.end();
    return device.vendor_id == k3Dconnexion && !is_another &&
           has_collection(descriptor, kMultiAxisController);
}

// Whether this interface of a known device is not the one to drive: a receiver also has a mouse's or a
// keyboard's interface under the same numbers. Without a descriptor the numbers decide.
bool is_other_interface(const HidDeviceInfo& device, const Result<ReportDescriptor>& descriptor) {
    if (device.report_descriptor.empty() || !descriptor) return false;
    const auto has_input = [&](Usage wanted) {
        return static_cast<bool>(descriptor->find(ReportKind::kInput, 0, wanted));
    };
    switch (device.kind) {
        case HidKind::kSpaceMouse:
            return !has_collection(*descriptor, kMultiAxisController) &&
                   !(has_input(kUsageX) && has_input(kUsageY) && has_input(kUsageZ));
        case HidKind::kDualSense:
        case HidKind::kForceJoystick:
            return !takes_forces(*descriptor) &&
                   (has_collection(*descriptor, kMouse) || has_collection(*descriptor, kKeyboard));
        case HidKind::kVecPedal:
        case HidKind::kUnknown:
            break;
    }
    return false;
}

std::string_view what_it_does(HidKind kind) {
    switch (kind) {
        case HidKind::kForceJoystick:
            return "moves the tool in radius and height and pushes back in both";
        case HidKind::kSpaceMouse:
            return "moves the tool in radius and height; no force; button 1 starts and stops the wheel, a "
                   "twist changes its speed";
        case HidKind::kDualSense:
            return "moves the tool by stick, touch pad or tilt; its right trigger presses into the work and "
                   "pushes back";
        case HidKind::kVecPedal:
            return "turns the wheel while a pedal is down, faster by the right one, slower by the left";
        case HidKind::kUnknown:
            break;
    }
    return {};
}

}  // namespace

std::string_view words_for(HidKind kind) {
    switch (kind) {
        case HidKind::kForceJoystick:
            return "force-feedback joystick";
        case HidKind::kSpaceMouse:
            return "SpaceMouse";
        case HidKind::kDualSense:
            return "DualSense";
        case HidKind::kVecPedal:
            return "foot pedal";
        case HidKind::kUnknown:
            break;
    }
    return "unknown device";
}

std::span<const KnownDevice> known_devices() noexcept {
    return kKnownDevices;
}

std::string udev_rule(std::uint16_t vendor_id, std::uint16_t product_id) {
    return fmt::format(
        R"(KERNEL=="hidraw*", ATTRS{{idVendor}}=="{:04x}", ATTRS{{idProduct}}=="{:04x}", MODE="0660", )"
        R"(GROUP="plugdev", TAG+="uaccess")",
        vendor_id, product_id);
}

std::string bluetooth_rule(std::uint16_t vendor_id, std::uint16_t product_id) {
    return fmt::format(
        R"(KERNEL=="hidraw*", KERNELS=="0005:{:04X}:{:04X}.*", MODE="0660", GROUP="plugdev", TAG+="uaccess")",
        vendor_id, product_id);
}

void recognise(HidDeviceInfo& device) {
    device.kind = kind_by_number(device);
    device.refusal.clear();
    device.remedy.clear();
    const auto descriptor = ReportDescriptor::parse(device.report_descriptor);
    if (is_other_interface(device, descriptor)) device.kind = HidKind::kUnknown;
    const bool by_descriptor = device.kind == HidKind::kUnknown || device.kind == HidKind::kForceJoystick;
    if (by_descriptor && !descriptor) {
        device.refusal = descriptor.error().message;
    } else if (device.kind == HidKind::kUnknown && is_newer_space_mouse(device, *descriptor)) {
        device.kind = HidKind::kSpaceMouse;
    } else if (device.kind == HidKind::kForceJoystick || (by_descriptor && takes_forces(*descriptor))) {
        device.kind = HidKind::kForceJoystick;
        if (const auto layout = PidLayout::find(*descriptor); !layout)
            device.refusal = layout.error().message;
    }
    device.can = what_it_does(device.kind);
    if (!device.refusal.empty()) return;
    if (device.kind == HidKind::kUnknown) {
        device.refusal = "no driver here knows it";
    } else if (!device.may_open) {
        device.refusal = "may not be opened by this user";
        const bool is_by_radio = device.bus == HidBusType::kBluetooth;
        device.remedy = fmt::format("put this line into /etc/udev/rules.d/70-onggi.rules and {} again: {}",
                                    is_by_radio ? "connect it" : "plug it in",
                                    is_by_radio ? bluetooth_rule(device.vendor_id, device.product_id)
                                                : udev_rule(device.vendor_id, device.product_id));
    }
}

}  // namespace onggi::haptics::hid

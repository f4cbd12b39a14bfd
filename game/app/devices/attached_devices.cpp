#include "game/app/devices/attached_devices.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "engine/haptics/haply/inverse_device.h"
#include "engine/haptics/hid/hid_kind.h"
#include "engine/haptics/hid/hid_list.h"

namespace onggi::app {
namespace {

using haptics::HidKind;
using State = haptics::hid::HidStatus::State;

constexpr std::string_view kAuto = "auto";
constexpr std::string_view kInverse = "inverse3";
constexpr std::string_view kNodes = "/dev/hidraw";

struct NamedKind {
    std::string_view word;
    HidKind kind;
};
// Devices with force come last: if several move at the same time, the last one gets the tool.
constexpr std::array<NamedKind, 3> kNamedKinds{{{"spacemouse", HidKind::kSpaceMouse},
                                                {"dualsense", HidKind::kDualSense},
                                                {"joystick", HidKind::kForceJoystick}}};

bool is_hex(std::string_view text) {
    return text.size() == 4 && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

bool are_numbers(std::string_view word) {
    return word.size() == 9 && word[4] == ':' && is_hex(word.substr(0, 4)) && is_hex(word.substr(5));
}

bool is_node(std::string_view word) {
    return word.starts_with(kNodes) && word.size() > kNodes.size() && word.size() < kNodes.size() + 8 &&
           word.find_first_not_of("0123456789", kNodes.size()) == std::string_view::npos;
}

// Finds the plugged-in device with that node or those numbers.
Result<haptics::HidDeviceInfo> find(const std::string& word) {
    const auto devices = haptics::list_hid_devices();
    if (!devices) return devices.error();
    std::string driven;
    for (const haptics::HidDeviceInfo& device : *devices) {
        const std::string numbers = fmt::format("{:04x}:{:04x}", device.vendor_id, device.product_id);
        if (device.path == word || numbers == word) {
            if (device.kind != HidKind::kUnknown) return device;
            return system_lacks(fmt::format("--device {}: {}", word, device.refusal));
        }
        if (device.kind != HidKind::kUnknown)
            driven += (driven.empty() ? "" : ", ") + device.path + " " + numbers;
    }
    return system_lacks(fmt::format("--device {}: expected it to be plugged in, found {}", word,
                                    driven.empty() ? "no supported device" : driven));
}

// Describes the device in a few words for a reader who does not know it.
std::string ability_of(const haptics::DeviceCapabilities& device, bool is_pedal) {
    if (is_pedal) return "turns the wheel";
    if (device.force_axes == 0) return "moves the tool";
    return fmt::format("moves the tool; pushes, {} {}, {:.1f} N", device.force_axes,
                       device.force_axes == 1 ? "axis" : "axes", device.peak_force_n);
}

OtherDevice inverse() {
    auto device = std::make_unique<haptics::InverseDevice>();
    haptics::InverseDevice& watched = *device;
    return {.word = "Haply Inverse3",
            .device = std::move(device),
            .status = [&watched]() -> const haptics::hid::HidStatus& { return watched.status(); }};
}

}  // namespace

bool names_a_device(const std::string& word) {
    const bool is_kind = std::any_of(kNamedKinds.begin(), kNamedKinds.end(),
                                     [&](const NamedKind& named) { return named.word == word; });
    return word == kAuto || word == kInverse || is_kind || is_node(word) || are_numbers(word);
}

AttachedDevices::Watched AttachedDevices::watch(haptics::HidDevice& device) {
    return {.kind = device.kind(),
            .word = std::string(haptics::hid::words_for(device.kind())),
            .status = [&device]() -> const haptics::hid::HidStatus& { return device.status(); },
            .ability = ability_of(device.capabilities(), device.kind() == HidKind::kVecPedal)};
}

void AttachedDevices::add(HidKind kind, const std::string& only,
                          std::vector<std::unique_ptr<haptics::HapticDevice>>& devices) {
    auto device = haptics::make_hid_device({.kind = kind, .only = only});
    tools_.push_back(watch(*device));
    devices.push_back(std::move(device));
}

void AttachedDevices::add(OtherDevice other, std::vector<std::unique_ptr<haptics::HapticDevice>>& devices) {
    tools_.push_back({.word = std::move(other.word),
                      .status = std::move(other.status),
                      .ability = ability_of(other.device->capabilities(), false)});
    devices.push_back(std::move(other.device));
}

Result<AttachedDevices> AttachedDevices::make(const std::string& word,
                                              std::unique_ptr<haptic::ToolDevice> first,
                                              bool first_is_a_recording, std::optional<OtherDevice> other) {
    AttachedDevices made;
    std::vector<std::unique_ptr<haptics::HapticDevice>> devices;
    made.first_ = first.get();
    devices.push_back(std::move(first));
    bool has_pedal = true;
    if (is_node(word) || are_numbers(word)) {
        const auto named = find(word);
        if (!named) return named.error();
        if (named->kind != HidKind::kVecPedal) made.add(named->kind, named->path, devices);
    } else {
        has_pedal = false;
        for (const NamedKind& kind : kNamedKinds) {
            if (word != kAuto && word != kind.word) continue;
            made.add(kind.kind, "", devices);
            has_pedal = true;
        }
        if (word == kAuto || word == kInverse) {
            made.add(inverse(), devices);
            has_pedal = true;
        }
    }
    if (other) made.add(std::move(*other), devices);
    made.group_ = std::make_unique<haptics::DeviceGroup>(
        std::move(devices), haptics::DeviceGroupOptions{.chooser = {.first_yields = first_is_a_recording}});
    if (has_pedal) {
        auto pedal = haptics::make_hid_device({.kind = HidKind::kVecPedal});
        made.pedals_.push_back(watch(*pedal));
        made.group_->add_pedal(std::move(pedal));
    }
    made.watched_group_ = made.group_.get();
    return made;
}

std::vector<std::string> AttachedDevices::news() {
    std::vector<std::string> lines;
    const auto tell = [&](Watched& watched) {
        const haptics::hid::HidStatus& now = watched.status();
        const bool is_same = now.state == watched.last.state && now.message == watched.last.message &&
                             now.times_found == watched.last.times_found;
        if (is_same) return;
        switch (now.state) {
            case State::kReady:
                lines.push_back(fmt::format("device: {} is here ({})", watched.name_of(now), now.path));
                break;
            case State::kAbsent:
                if (watched.last.state == State::kReady)
                    lines.push_back(fmt::format("device: {} is gone", watched.name_of(watched.last)));
                break;
            case State::kRefused:
            case State::kFailed:
                lines.push_back(fmt::format("device: {} is not used: {}", watched.name_of(now), now.message));
                break;
        }
        watched.last = now;
    };
    std::for_each(tools_.begin(), tools_.end(), tell);
    std::for_each(pedals_.begin(), pedals_.end(), tell);
    return lines;
}

std::string AttachedDevices::holder() const {
    const std::size_t holder = watched_group_->holder();
    if (holder == 0) return {};
    const Watched& watched = tools_[holder - 1];
    return watched.name_of(watched.last);
}

bool AttachedDevices::somebody_moved() {
    const std::uint64_t now = watched_group_->signs_of_life();
    return std::exchange(signs_of_life_, now) != now;
}

std::vector<std::string> AttachedDevices::restless() const {
    std::vector<std::string> names;
    std::uint32_t bits = watched_group_->restless();
    for (const std::vector<Watched>* list : {&tools_, &pedals_}) {
        for (const Watched& watched : *list) {
            bits >>= 1U;  // the first device's is the lowest
            if ((bits & 1U) != 0) names.push_back(watched.name_of(watched.last));
        }
    }
    return names;
}

bool AttachedDevices::has_device() const {
    return std::any_of(tools_.begin(), tools_.end(),
                       [](const Watched& watched) { return watched.last.state == State::kReady; });
}

std::vector<AttachedDevices::Seen> AttachedDevices::seen() const {
    std::vector<Seen> seen;
    const auto add_one = [&](const Watched& watched) {
        if (watched.last.state == State::kAbsent) return;
        seen.push_back({.name = watched.name_of(watched.last),
                        .ability = watched.ability,
                        .works = watched.last.state == State::kReady,
                        .why_not = watched.last.message});
    };
    std::for_each(tools_.begin(), tools_.end(), add_one);
    std::for_each(pedals_.begin(), pedals_.end(), add_one);
    return seen;
}

bool AttachedDevices::drives(std::uint16_t vendor_id, std::uint16_t product_id) const {
    const auto known = haptics::hid::known_devices();
    const auto entry = std::find_if(known.begin(), known.end(), [&](const haptics::hid::KnownDevice& one) {
        return one.vendor_id == vendor_id && one.product_id == product_id;
    });
    return entry != known.end() && std::any_of(tools_.begin(), tools_.end(), [&](const Watched& watched) {
               return watched.kind == entry->kind && watched.last.state == State::kReady;
           });
}

}  // namespace onggi::app

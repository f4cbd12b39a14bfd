#include "game/app/command_line/device_probes.h"

#include <fmt/format.h>
#include <unistd.h>

#include <string>

#include "engine/haptics/haply/service_probe.h"
#include "engine/haptics/hid/hid_kind.h"
#include "engine/haptics/stop_key.h"
#include "engine/sound/openal_player.h"
#include "engine/window/window.h"

namespace onggi::app {
namespace {

using Verdict = Finding::Verdict;

std::string name_of(const haptics::HidDeviceInfo& device) {
    return fmt::format("{} {:04x}:{:04x} {}", device.path, device.vendor_id, device.product_id,
                       device.name.empty() ? "(no name)" : device.name);
}

}  // namespace

Finding probe_stop_keys(const std::string& folder) {
    const std::vector<haptics::StopKeyboard> keyboards = haptics::open_stop_keys({}, folder);
    for (const haptics::StopKeyboard& keyboard : keyboards)
        ::close(keyboard.file);
    if (!keyboards.empty())
        return {.subject = "stop key",
                .found = fmt::format("Pause and Stop are heard of {} {}, whatever the picture does",
                                     keyboards.size(), keyboards.size() == 1 ? "keyboard" : "keyboards")};
    return {.subject = "stop key",
            .verdict = Verdict::kNote,
            .found = fmt::format(
                "Pause is heard by the window alone: no keyboard below {} has a stop key and may be "
                "read; members of the group input may read them",
                folder)};
}

Finding finding_for(const haptics::HidDeviceInfo& device) {
    Finding finding{.subject = "device", .found = name_of(device)};
    if (device.kind == haptics::HidKind::kUnknown) {
        finding.verdict = Verdict::kNote;  // most are keyboards and mice, which reach the window without us
        finding.found += ": " + device.refusal;
    } else if (device.refusal.empty()) {
        finding.found += fmt::format(": {}; {}", haptics::hid::words_for(device.kind), device.can);
    } else {
        finding.verdict = Verdict::kLacking;
        finding.found += fmt::format(": {}; {}", haptics::hid::words_for(device.kind), device.refusal);
        finding.cost = fmt::format("it is not used; it {}", device.can);
        finding.remedy = device.remedy.empty() ? "none is known for this device" : device.remedy;
    }
    return finding;
}

Finding probe_inverse(const haptics::haply::InverseOptions& options) {
    const auto service = haptics::haply::find_service(options);
    if (service) {
        return {.subject = "device",
                .found = fmt::format("Haply Inverse3: its service is found at {}:{}; moves the tool in three "
                                     "axes and pushes back in all of them once the device is plugged in",
                                     options.host, options.port)};
    }
    // Few have one: no lack.
    return {
        .subject = "device",
        .verdict = Verdict::kNote,
        .found = fmt::format("Haply Inverse3: looked for at {}:{} while the wheel runs; not found now: {}; "
                             "its maker's service must be installed and run",
                             options.host, options.port, service.error().message)};
}

Finding probe_sound() {
    const std::string obstacle = sound::why_no_sound();
    if (obstacle.empty()) return {.subject = "sound", .found = "a sound card or a sound server"};
    return {.subject = "sound",
            .verdict = Verdict::kLacking,
            .found = obstacle,
            .cost = "the wheel is silent; who feels no force and sees little misses what the clay does",
            .remedy = "plug in a loudspeaker, or start a sound server (PipeWire, PulseAudio)"};
}

std::vector<Finding> probe_haptic_devices() {
    std::vector<Finding> findings{
        {.subject = "device", .found = "simulated tool: mouse or touch, always there; the tool lags behind"}};
    const auto devices = haptics::list_hid_devices();
    if (!devices) {
        findings.push_back({.subject = "device",
                            .verdict = Verdict::kLacking,
                            .found = devices.error().message,
                            .cost = "HID devices cannot be seen",
                            .remedy = "check that /sys/class/hidraw can be read"});
        return findings;
    }
    for (const haptics::HidDeviceInfo& device : *devices)
        findings.push_back(finding_for(device));
    for (const window::Gamepad& pad : window::find_gamepads()) {
        findings.push_back(
            {.subject = "device",
             .found = fmt::format("gamepad {}: sticks move the tool, triggers turn the wheel; no force",
                                  pad.name.empty() ? "(no name)" : pad.name)});
    }
    findings.push_back(probe_inverse({}));
    return findings;
}

}  // namespace onggi::app

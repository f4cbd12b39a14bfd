#include "game/app/command_line/finding.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "engine/core/list_folder.h"
#include "engine/files/asset_folder.h"
#include "engine/haptics/haply/service_probe.h"
#include "engine/haptics/hid/hid_kind.h"
#include "engine/haptics/stop_key.h"
#include "engine/sound/openal_player.h"
#include "engine/sound/speech_program.h"
#include "engine/window/window.h"
#include "game/app/kiosk/kiosk_settings.h"
#include "game/app/kiosk/presentation/kiosk_voice.h"
#include "game/app/sharing/listen_place.h"
#include "game/screens/page/fonts.h"
#include "game/wheel/wheel_scene.h"
#include "game/wheel/workshop_files.h"

namespace onggi::app {
namespace {

const char* word_for(Finding::Verdict verdict) {
    switch (verdict) {
        case Finding::Verdict::kGood:
            return "good";
        case Finding::Verdict::kNote:
            return "note";
        case Finding::Verdict::kLacking:
            return "lacking";
    }
    return "";
}

using Verdict = Finding::Verdict;

std::string name_of(const haptics::HidDeviceInfo& device) {
    return fmt::format("{} {:04x}:{:04x} {}", device.path, device.vendor_id, device.product_id,
                       device.name.empty() ? "(no name)" : device.name);
}

namespace fs = std::filesystem;

constexpr double kBytesPerGb = 1e9;
constexpr double kEnoughDiskGb = 2.0;

void add_file_names_below(const fs::path& folder, std::set<std::string>& names) {
    std::error_code ignored;
    for (const fs::path& entry : list_folder(folder).entries) {
        names.insert(entry.filename().string());
        if (fs::is_directory(fs::symlink_status(entry, ignored))) add_file_names_below(entry, names);
    }
}

std::string words_of(const kiosk::Config& config) {
    std::string words = fmt::format("visits begin in {}, of {}; {} clay", config.languages.first,
                                    fmt::join(config.languages.order, ", "),
                                    config.visit.forgiving ? "forgiving" : "unforgiving");
    words += config.staff.pin.empty() ? "; no staff panel without a PIN" : "; a PIN for the staff";
    if (config.staff.locked) words += "; locked";
    if (config.hours.opens_min != config.hours.closes_min)
        words += fmt::format("; open {:02}:{:02} to {:02}:{:02}", config.hours.opens_min / 60,
                             config.hours.opens_min % 60, config.hours.closes_min / 60,
                             config.hours.closes_min % 60);
    return words;
}

// A missing gallery will be created in its first existing parent folder.
Finding probe_gallery(const kiosk::Config& config) {
    std::error_code error;
    fs::path there = fs::absolute(config.gallery.folder, error);
    while (!fs::exists(there, error) && there.has_relative_path())
        there = there.parent_path();
    const fs::space_info space = fs::space(there, error);
    const double free_mb = error ? 0.0 : static_cast<double>(space.available) / kiosk::kBytesPerMb;
    Finding finding{.subject = "gallery",
                    .found = fmt::format("{:.0f} MB free for pots in {}", free_mb, config.gallery.folder)};
    if (free_mb >= config.gallery.least_free_mb) return finding;
    finding.verdict = Verdict::kLacking;
    finding.found += fmt::format(", the settings require {:.0f}", config.gallery.least_free_mb);
    finding.cost = "no pot is kept; visitors are told that the shelf is full";
    finding.remedy = "free some space, or name another gallery.folder in the settings";
    return finding;
}

// If sharing is on: checks whether the outbox can be written and whether the server answers.
std::vector<Finding> probe_sharing(const kiosk::Config& config) {
    const auto& sharing = config.sharing;
    std::vector<Finding> findings;
    if (!kiosk::shares(config)) return findings;
    const bool writable = ::faccessat(AT_FDCWD, sharing.outbox.c_str(), W_OK | X_OK, AT_EACCESS) == 0 ||
                          !fs::exists(sharing.outbox);
    if (!writable) {
        findings.push_back(
            {.subject = "sharing",
             .verdict = Verdict::kLacking,
             .found = fmt::format("{}: expected an outbox that can be written, found none", sharing.outbox),
             .cost = "no pot is taken home by phone",
             .remedy = "give the folder to the kiosk's user, or name another sharing.outbox"});
    }
    if (sharing.listen.empty()) {
        findings.push_back({.subject = "sharing",
                            .found = fmt::format("pots lie in {} for the web server of {}", sharing.outbox,
                                                 sharing.public_url)});
        return findings;
    }
    const auto address = address_of(sharing.listen);
    constexpr int kMostMs = 500;
    if (address && answers_at(*address, sharing.port, kMostMs)) {
        findings.push_back({.subject = "sharing",
                            .found = fmt::format("pots lie in {}, and {}, port {}, answers", sharing.outbox,
                                                 *address, sharing.port)});
        return findings;
    }
    findings.push_back(
        {.subject = "sharing",
         .verdict = Verdict::kLacking,
         .found = address ? fmt::format("no answer from {}, port {}", *address, sharing.port)
                          : address.error().message,
         .cost = "phones find no pot",
         .remedy = "systemctl enable --now onggi-share (or run onggi share), and look at sharing.listen"});
    return findings;
}

Finding probe_speech(const kiosk::Config& config) {
    const std::string& speech = config.sound.speech;
    Finding finding{.subject = "speech", .found = "off"};
    if (speech == "off") return finding;
    if (sound::has_speech_program()) {
        finding.found = speech == "on" ? "by espeak-ng, in every visit" : "by espeak-ng, with headphones";
        return finding;
    }
    const bool is_asked = speech == "on";
    finding.verdict = is_asked ? Verdict::kLacking : Verdict::kNote;
    finding.found = is_asked ? kNoSpeechProgram : "none with headphones: espeak-ng is not installed";
    finding.cost = "visitors who cannot see the screen hear nothing of it";
    finding.remedy = "apt-get install espeak-ng";
    return finding;
}

// Opens the room of the settings as the kiosk does.
Finding probe_room(const std::string& room) {
    constexpr int kWidthPx = 1280;
    constexpr int kHeightPx = 720;
    const wheel::OpenedScene opened = wheel::open_scene(room, kWidthPx, kHeightPx);
    if (opened.lack.empty()) {
        return {.subject = "room",
                .verdict = opened.note.empty() ? Verdict::kGood : Verdict::kNote,
                .found = fmt::format("the museum's own, {}{}", room,
                                     opened.note.empty() ? "" : "; not drawn: " + opened.note)};
    }
    return {.subject = "room",
            .verdict = Verdict::kLacking,
            .found = opened.lack,
            .cost = "the wheel is shown in the program's own room",
            .remedy = "fix what the message names, or remove room from [screen]"};
}

}  // namespace

std::string findings_as_text(std::span<const Finding> findings) {
    std::size_t width = 0;
    for (const Finding& finding : findings)
        width = std::max(width, finding.subject.size());
    std::string text;
    const auto add_line = [&](std::string_view verdict, std::string_view subject, std::string_view words) {
        text += fmt::format("{:<8} {:<{}}  {}\n", verdict, subject, width, words);
    };
    for (const Finding& finding : findings) {
        add_line(word_for(finding.verdict), finding.subject, finding.found);
        if (finding.verdict != Finding::Verdict::kLacking) continue;
        add_line("", "", "costs: " + finding.cost);
        add_line("", "", "mend: " + finding.remedy);
    }
    return text;
}

bool any_lacking(std::span<const Finding> findings) {
    return std::any_of(findings.begin(), findings.end(),
                       [](const Finding& finding) { return finding.verdict == Finding::Verdict::kLacking; });
}

Finding probe_stop_keys(const std::string& folder) {
    const std::vector<haptics::StopKeyboard> keyboards = haptics::open_stop_keys({}, folder);
    for (const haptics::StopKeyboard& keyboard : keyboards)
        ::close(keyboard.file);
    if (!keyboards.empty())
        return {.subject = "stop key",
                .found = fmt::format("Pause and Stop work on {} {}, even if the picture hangs",
                                     keyboards.size(), keyboards.size() == 1 ? "keyboard" : "keyboards")};
    return {.subject = "stop key",
            .verdict = Verdict::kNote,
            .found = fmt::format("Pause works in the window only: no readable keyboard in {} has a stop key; "
                                 "members of the group input may read them",
                                 folder)};
}

Finding finding_for(const haptics::HidDeviceInfo& device) {
    Finding finding{.subject = "device", .found = name_of(device)};
    if (device.kind == haptics::HidKind::kUnknown) {
        finding.verdict = Verdict::kNote;  // mostly keyboards and mice, which the window system handles
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
    // Few machines have one, so this is not a lack.
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
    return {
        .subject = "sound",
        .verdict = Verdict::kLacking,
        .found = obstacle,
        .cost = "the wheel is silent; visitors without a force or with poor sight miss what the clay does",
        .remedy = "plug in a loudspeaker, or start a sound server (PipeWire, PulseAudio)"};
}

std::vector<Finding> probe_haptic_devices() {
    std::vector<Finding> findings{
        {.subject = "device",
         .found = "simulated tool: mouse or touch, always available; the tool lags behind"}};
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

std::vector<Finding> probe_settings(const std::string& file, const std::string& usual) {
    std::error_code error;
    if (file.empty() && !fs::exists(usual, error)) {
        return {{.subject = "settings",
                 .verdict = Verdict::kNote,
                 .found = fmt::format(
                     "none in {}: the kiosk starts with defaults unless --config names settings", usual)}};
    }
    const std::string& read = file.empty() ? usual : file;
    const auto settings = load_settings(read);
    if (!settings) {
        return {{.subject = "settings",
                 .verdict = Verdict::kLacking,
                 .found = settings.error().message,
                 .cost = "the kiosk does not start with them; with --or-config it uses others and reports it",
                 .remedy = "fix what the message names; assets/kiosk.toml shows every setting"}};
    }
    std::vector<Finding> findings{
        {.subject = "settings", .found = fmt::format("{}: {}", read, words_of(settings->config))}};
    for (const std::string& remark : settings->remarks)
        findings.push_back({.subject = "settings", .verdict = Verdict::kNote, .found = remark});
    if (!settings->config.screen.room.empty()) findings.push_back(probe_room(settings->config.screen.room));
    findings.push_back(probe_speech(settings->config));
    findings.push_back(probe_gallery(settings->config));
    for (Finding& finding : probe_sharing(settings->config))
        findings.push_back(std::move(finding));
    return findings;
}

Finding probe_display() {
    const std::string obstacle = window::why_no_display();
    if (obstacle.empty()) return {.subject = "display", .found = "a window can be opened"};
    return {.subject = "display",
            .verdict = Verdict::kLacking,
            .found = obstacle,
            .cost = "no window: pots are thrown from gestures only (onggi throw)",
            .remedy = "start from a desktop session, or set DISPLAY to a running X server"};
}

Finding probe_workshop() {
    const Finding lacking{
        .subject = "workshop",
        .verdict = Verdict::kLacking,
        .cost = "the wheel is shown before a plain wall instead of in its workshop",
        .remedy = "install the program with its share/onggi folder, or name one by ONGGI_ASSETS"};
    const auto without = [&](const std::string& why) {
        Finding finding = lacking;
        finding.found = why;
        return finding;
    };
    const auto folder = files::find_asset("workshop");
    if (!folder) return without(folder.error().message);
    const auto workshop = wheel::load_workshop(*folder);
    if (!workshop) return without(workshop.error().message);
    for (const wheel::BackgroundCamera& camera : workshop->cameras) {
        const auto background = wheel::load_background(*workshop, camera);
        if (!background) return without(background.error().message);
    }
    return {.subject = "workshop",
            .found = fmt::format("{} cameras with their photographs in {}", workshop->cameras.size(),
                                 folder->string())};
}

Finding probe_disk(const fs::path& folder) {
    std::error_code error;
    const fs::space_info space = fs::space(folder, error);
    if (error) {
        return {.subject = "disk",
                .verdict = Verdict::kLacking,
                .found = fmt::format("{}: {}", folder.string(), error.message()),
                .cost = "pots and sessions cannot be kept there",
                .remedy = "start onggi in a folder that can be written"};
    }
    const double free_gb = static_cast<double>(space.available) / kBytesPerGb;
    const std::string found = fmt::format("{:.1f} GB free in {}", free_gb, folder.string());
    if (free_gb >= kEnoughDiskGb) return {.subject = "disk", .found = found};
    return {.subject = "disk",
            .verdict = Verdict::kLacking,
            .found = found,
            .cost = fmt::format(
                "below {:.0f} GB a day's sessions may not fit; exports then fail with exit code 3",
                kEnoughDiskGb),
            .remedy = "free some space, or start onggi in a folder on a larger disk"};
}

std::vector<fs::path> font_folders() {
    std::vector<fs::path> folders{"/usr/share/fonts", "/usr/local/share/fonts"};
    if (const char* home = std::getenv("HOME")) folders.push_back(fs::path(home) / ".local/share/fonts");
    return folders;
}

Finding probe_fonts(const std::vector<fs::path>& folders, std::span<const std::string> languages) {
    std::set<std::string> names;
    for (const fs::path& folder : folders)
        add_file_names_below(folder, names);
    std::set<std::string> missing;
    std::set<std::string> packages;
    for (const screens::FontFamily& family : screens::needed_families(languages)) {
        const auto first = names.lower_bound(std::string(family.file_prefix));
        if (first != names.end() && first->starts_with(family.file_prefix)) continue;
        missing.insert(std::string(family.name));
        packages.insert(std::string(family.package));
    }
    if (missing.empty()) return {.subject = "fonts", .found = "all families of the visitor's screens"};
    return {.subject = "fonts",
            .verdict = Verdict::kLacking,
            .found = fmt::format("without {}", fmt::join(missing, ", ")),
            .cost = "the kiosk's texts use other fonts, or show empty boxes for missing letters",
            .remedy = fmt::format("apt-get install {}", fmt::join(packages, " "))};
}

}  // namespace onggi::app

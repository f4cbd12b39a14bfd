#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "engine/core/result.h"
#include "engine/jobs/thread_setup.h"
#include "engine/vk/physical_device.h"
#include "game/app/command_line/commands.h"
#include "game/app/command_line/finding.h"
#include "game/app/command_line/options.h"
#include "game/app/kiosk/kiosk_settings.h"
#include "game/app/system/haptic_core.h"
#include "game/wheel/live_screen.h"

namespace onggi::app {
namespace {

using Verdict = Finding::Verdict;

using render::BackendChoice;

// Reports the backend for this device, the first quality level and the range of levels.
Finding probe_quality(const vk::DeviceDescription& device, BackendChoice backend) {
    const int threads = draw_threads(jobs::choose_haptic_core());
    const render::DeviceClass counts_as = render::class_for(backend, wheel::device_class(device));
    const render::QualityRange range = render::quality_range(counts_as, threads);
    const bool by_processor = counts_as == render::DeviceClass::kSoftware;
    Finding finding{
        .subject = "picture",
        .found = fmt::format("backend {}: drawn by the {}; begins as for {}; frame times move it "
                             "between {} and {}",
                             render::backend_choice_name(backend),
                             by_processor      ? "processor"
                             : device.is_cpu() ? "device, which is software"
                                               : "GPU",
                             render::quality_name(range.first), render::quality_name(range.lowest),
                             render::quality_name(range.highest))};
    if (!by_processor && device.is_cpu()) {
        finding.verdict = Verdict::kNote;
        finding.cost = "a few frames a second, for testing what a GPU would draw";
        finding.remedy = "leave the backend at auto, or install a driver for a GPU";
    }
    return finding;
}

// Returns the backend of the option, else of the settings, else auto.
BackendChoice backend_of(const std::optional<BackendChoice>& asked, const std::string& settings) {
    if (asked) return *asked;
    std::error_code error;
    const std::string file = settings.empty() ? kUsualSettings : settings;
    if (!std::filesystem::exists(file, error)) return BackendChoice::kAuto;
    const auto read = load_settings(file);
    if (!read) return BackendChoice::kAuto;  // errors in the settings are a separate finding
    return render::backend_choice_named(read->config.screen.backend).value_or(BackendChoice::kAuto);
}

std::vector<Finding> probe_vulkan(BackendChoice backend) {
    Finding none{.subject = "vulkan",
                 .verdict = Verdict::kLacking,
                 .cost = "no picture: no window and no --screenshot; pots can still be thrown and exported",
                 .remedy = "apt-get install mesa-vulkan-drivers"};
    const std::string request = vk::device_request_of_environment();
    const vk::DevicePreference preference{.cpu_first = backend == BackendChoice::kCpu};
    const auto devices = vk::describe_devices(request, preference);
    if (!devices || devices->empty()) {
        none.found = devices ? "no device" : devices.error().message;
        return {none};
    }
    std::vector<Finding> findings;
    for (const vk::DeviceDescription& device : *devices) {
        std::string words = fmt::format("device {}: {}, {}, {} {}, Vulkan {}", device.index, device.name,
                                        vk::type_name(device.type), device.driver, device.driver_info,
                                        vk::version_name(device.api_version));
        if (!device.lacks.empty()) words += ", lacks " + device.lacks;
        if (device.chosen) words += ", chosen";
        findings.push_back({.subject = "vulkan",
                            .verdict = device.chosen ? Verdict::kGood : Verdict::kNote,
                            .found = std::move(words)});
        if (device.chosen) findings.push_back(probe_quality(device, backend));
    }
    if (const auto chosen = vk::choose(*devices, request, preference); !chosen) {
        none.found = chosen.error().message;
        if (chosen.error().kind == ErrorKind::kBadInput)
            none.remedy = "set ONGGI_VULKAN_DEVICE to one of these, or unset it";
        findings.push_back(std::move(none));
    }
    return findings;
}

std::vector<Finding> probe_haptic_loop() {
    const jobs::CoreChoice choice = jobs::choose_haptic_core();
    const jobs::RealTimeReport report = jobs::probe_real_time({.core = choice});
    std::vector<Finding> findings;
    if (choice.core >= 0 && !choice.shared()) {
        findings.push_back({.subject = "cores",
                            .found = fmt::format("the haptic loop gets core {}, everything else {}",
                                                 choice.core, fmt::join(choice.others, ", "))});
    }
    for (const jobs::RealTimeLack& lack : report.lacks()) {
        findings.push_back({.subject = "real time",
                            .verdict = Verdict::kLacking,
                            .found = lack.what,
                            .cost = lack.cost,
                            .remedy = lack.remedy});
    }
    if (report.nothing_refused()) {
        findings.push_back(
            {.subject = "real time", .found = "SCHED_FIFO, locked memory and a pinned thread"});
    }
    return findings;
}

int examine(const std::string& settings, const std::optional<BackendChoice>& backend, bool strict) {
    std::vector<Finding> findings;
    const auto add = [&](std::vector<Finding> more) {
        findings.insert(findings.end(), std::make_move_iterator(more.begin()),
                        std::make_move_iterator(more.end()));
    };
    add(probe_vulkan(backend_of(backend, settings)));
    findings.push_back(probe_display());
    add(probe_haptic_loop());
    add(probe_haptic_devices());
    findings.push_back(probe_stop_keys());
    findings.push_back(probe_sound());
    findings.push_back(probe_workshop());
    findings.push_back(probe_disk(std::filesystem::current_path()));
    // Settings that cannot be read have a finding of their own.
    const auto config = read_config_file(settings.empty() ? kUsualSettings : settings);
    findings.push_back(probe_fonts(font_folders(), (config ? *config : kiosk::Config()).languages.order));
    add(probe_settings(settings));

    std::fputs(findings_as_text(findings).c_str(), stdout);
    return strict && any_lacking(findings) ? exit_code(ErrorKind::kSystemLacks) : 0;
}

}  // namespace

void add_doctor_command(CLI::App& program, int& exit_status) {
    CLI::App* command = program.add_subcommand(
        "doctor",
        "Report what this machine has and lacks: Vulkan, real time, cores, devices, disk, display, settings");
    const auto strict = std::make_shared<bool>(false);
    command->add_flag("--strict", *strict, "exit with 3 where something is lacking");
    const auto settings = std::make_shared<std::string>();
    command
        ->add_option("--config", *settings,
                     fmt::format("settings of a kiosk to check; default: those in {}", kUsualSettings))
        ->type_name("FILE.toml");
    const auto backend = std::make_shared<std::optional<BackendChoice>>();
    add_backend_option(*command, *backend, "the backend to check, overriding the settings");
    command->callback(
        [strict, settings, backend, &exit_status] { exit_status = examine(*settings, *backend, *strict); });
}

}  // namespace onggi::app

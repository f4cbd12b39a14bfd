#include "game/app/system_probes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>
#include <string_view>
#include <system_error>

#include "engine/files/asset_folder.h"
#include "engine/window/window.h"
#include "game/wheel/workshop_files.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;
using Verdict = Finding::Verdict;

constexpr double kBytesPerGb = 1e9;
constexpr double kEnoughDiskGb = 2.0;

struct FontFamily {
    std::string_view name;
    std::string_view file_prefix;
    std::string_view package;
};
constexpr std::array<FontFamily, 4> kFontFamilies{{
    {"NanumSquareRound", "NanumSquareRound", "fonts-nanum"},
    {"NanumMyeongjo", "NanumMyeongjo", "fonts-nanum"},
    {"Noto Sans Arabic", "NotoSansArabic", "fonts-noto-core"},
    {"Noto Naskh Arabic", "NotoNaskhArabic", "fonts-noto-core"},
}};

std::set<std::string> file_names_below(const std::vector<fs::path>& folders) {
    std::set<std::string> names;
    for (const fs::path& folder : folders) {
        std::error_code error;
        auto entry =
            fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, error);
        for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
            names.insert(entry->path().filename().string());
        }
    }
    return names;
}

}  // namespace

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
        .cost = "the wheel stands before a plain wall instead of in its workshop",
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
    for (const wheel::PlateCamera& camera : workshop->cameras) {
        const auto plate = wheel::load_plate(*workshop, camera);
        if (!plate) return without(plate.error().message);
    }
    return {.subject = "workshop",
            .found = fmt::format("{} cameras with their plates in {}", workshop->cameras.size(),
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

Finding probe_fonts(const std::vector<fs::path>& folders) {
    const std::set<std::string> names = file_names_below(folders);
    std::set<std::string> missing;
    std::set<std::string> packages;
    for (const FontFamily& family : kFontFamilies) {
        const auto first = names.lower_bound(std::string(family.file_prefix));
        if (first != names.end() && first->starts_with(family.file_prefix)) continue;
        missing.insert(std::string(family.name));
        packages.insert(std::string(family.package));
    }
    if (missing.empty()) return {.subject = "fonts", .found = "all families of the visitor's screens"};
    return {
        .subject = "fonts",
        .verdict = Verdict::kLacking,
        .found = fmt::format("without {}", fmt::join(missing, ", ")),
        .cost = "the kiosk's words are set in other fonts, or are empty boxes where none has their letters",
        .remedy = fmt::format("apt-get install {}", fmt::join(packages, " "))};
}

}  // namespace onggi::app

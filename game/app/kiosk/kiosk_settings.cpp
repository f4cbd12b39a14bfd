#include "game/app/kiosk/kiosk_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "engine/files/asset_folder.h"
#include "engine/files/atomic_file.h"
#include "engine/files/read_file.h"
#include "game/app/kiosk/presentation/exhibits.h"
#include "game/heritage/jar.h"
#include "game/screens/page/legibility.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostTextBytes = std::size_t{1} << 20U;

// Reads the museum's own table, or uses the built-in one if that is missing or invalid. Empty: an invalid
// table of a language that is not built in. Bad input: a language without any table.
Result<std::optional<kiosk::Language>> language_of(const std::string& code, const fs::path& folder,
                                                   std::vector<std::string>& remarks) {
    const auto& built_in = kiosk::built_in_languages();
    const auto found = std::find_if(built_in.begin(), built_in.end(),
                                    [&](const kiosk::Language& one) { return one.code() == code; });
    const fs::path file = folder / (code + ".tsv");
    std::error_code error;
    if (!folder.empty() && fs::exists(file, error)) {
        const auto table = files::read_file(file, kMostTextBytes);
        auto language = table ? kiosk::Language::read(*table, code, file.string(), &built_in.front())
                              : Result<kiosk::Language>(table.error());
        if (language && !language->missing_keys().empty()) {
            remarks.push_back(fmt::format(
                "{}: expected every text, found {} missing, the first {}; English stands in", file.string(),
                language->missing_keys().size(), language->missing_keys().front()));
        }
        if (language) return std::optional(std::move(*language));
        const bool is_built_in = found != built_in.end();
        remarks.push_back(language.error().message +
                          (is_built_in ? "; the built-in words stand in" : "; the kiosk goes on without it"));
        if (!is_built_in) return std::optional<kiosk::Language>();
    }
    if (found != built_in.end()) return std::optional(*found);
    return bad_input(fmt::format("languages: expected a table {} for '{}', found none",
                                 folder.empty() ? fs::path(code + ".tsv").string() : file.string(), code));
}

// Has the format of a kiosk's settings.
constexpr const char* kKeptSettings = "staff.toml";

}  // namespace

fs::path statistics_folder(const kiosk::Config& config) {
    const std::string& wanted = config.staff.statistics_folder;
    return wanted.empty() ? fs::path(config.gallery.folder) / "statistics" : fs::path(wanted);
}

Result<void> keep_house(const fs::path& folder, const HouseDefaults& house) {
    std::error_code error;
    fs::create_directories(folder, error);
    return files::write_file_atomically(
        folder / kKeptSettings,
        fmt::format("[sound]\nvolume = {}\n\n[languages]\norder = [\"{}\"]\nfirst = \"{}\"\n", house.volume,
                    house.language, house.language));
}

void take_kept_house(KioskSettings& settings) {
    std::error_code error;
    const std::string file = statistics_folder(settings.config) / kKeptSettings;
    if (!settings.config.sound.remember_staff || !fs::exists(file, error)) return;
    const auto kept = read_config_file(file);
    if (!kept) {
        settings.remarks.push_back(kept.error().message + "; the settings' own count");
        return;
    }
    settings.config.sound.volume = settings.rules.default_volume = kept->sound.volume;
    if (!settings.languages) return;
    const auto known =
        std::find_if(settings.languages->begin(), settings.languages->end(),
                     [&](const kiosk::Language& one) { return one.code() == kept->languages.first; });
    if (known != settings.languages->end())
        settings.rules.default_language = static_cast<int>(known - settings.languages->begin());
}

// Text grows with the configured distance within its box; targets do not grow.
std::vector<std::string> panel_lacks(const kiosk::Config& config, int width_px, int height_px) {
    const double inches = config.screen.diagonal_inch;
    const double px_per_mm = screens::px_per_mm(width_px, height_px, inches);
    const double degrees =
        screens::smallest_text_degrees(width_px, height_px, px_per_mm, config.screen.distance_mm);
    std::vector<std::string> lacks;
    if (degrees < screens::kLeastCapitalDegrees) {
        const double fraction = screens::kLeastCapitalDegrees / degrees;
        lacks.push_back(fmt::format(
            "screen: expected capitals of {} degrees, found {:.2f} in the smallest words at {:.0f} mm from "
            "{} inches; a panel of {:.0f} inches or a distance of {:.0f} mm would do",
            screens::kLeastCapitalDegrees, degrees, config.screen.distance_mm, inches,
            std::ceil(inches * fraction), std::floor(config.screen.distance_mm / fraction)));
    }
    const double target_mm = screens::smallest_target_mm(width_px, height_px, px_per_mm);
    if (target_mm < screens::kLeastTargetMm) {
        lacks.push_back(fmt::format(
            "screen: expected targets of {:.0f} mm, found {:.1f} in the smallest on {} inches; a panel of "
            "{:.0f} inches would do",
            screens::kLeastTargetMm, target_mm, inches,
            std::ceil(inches * screens::kLeastTargetMm / target_mm)));
    }
    return lacks;
}

Result<kiosk::Config> read_config_file(const std::string& file) {
    const auto text = files::read_file(file, kMostTextBytes);
    if (!text) return text.error();
    return kiosk::read_config(*text, file);
}

Result<KioskSettings> load_settings(const std::string& config_file) {
    KioskSettings settings;
    if (!config_file.empty()) {
        auto config = read_config_file(config_file);
        if (!config) return config.error();
        settings.config = std::move(*config);
    }
    const kiosk::Config& config = settings.config;
    settings.rules = kiosk::rules_of(config);
    std::vector<kiosk::Language> languages;
    for (const std::string& code : config.languages.order) {
        auto language = language_of(code, config.languages.folder, settings.remarks);
        if (!language) return language.error();
        if (!*language) continue;
        languages.push_back(std::move(**language));
        if (code == config.languages.first)
            settings.rules.default_language = static_cast<int>(languages.size()) - 1;
    }
    if (languages.empty()) languages.push_back(kiosk::built_in_languages().front());
    settings.rules.language_count = static_cast<int>(languages.size());
    settings.languages = std::make_shared<const std::vector<kiosk::Language>>(std::move(languages));

    const auto folder = files::find_asset("heritage");
    const auto targets =
        folder ? heritage::load_targets(*folder) : Result<std::vector<heritage::Target>>(folder.error());
    if (targets) {
        settings.targets = *targets;
    } else {
        settings.remarks.push_back(targets.error().message);  // free throwing works without targets
    }
    ExhibitWords words{.shelf = {}, .cards = {}, .languages = *settings.languages};
    if (targets) {
        if (auto shelf = heritage::load_shelf(*folder, settings.targets)) {
            words.shelf = std::move(*shelf);
        } else {
            settings.remarks.push_back(shelf.error().message);  // the table of targets has names, too
        }
        if (auto cards = heritage::load_cards(*folder, settings.targets)) {
            words.cards = std::move(*cards);
        } else {
            settings.remarks.push_back(cards.error().message);  // the shelf works without cards
        }
    }
    settings.exhibits = std::make_shared<const std::vector<screens::Exhibit>>(
        exhibits_of(settings.targets, words, settings.exhibit_places));
    settings.relatives =
        std::make_shared<const std::vector<screens::Exhibit>>(relatives_of(settings.targets, words));
    settings.rules.target_count = static_cast<int>(settings.exhibits->size());
    for (int place = 0; place < settings.rules.target_count; ++place) {
        const std::size_t row = settings.exhibit_places[static_cast<std::size_t>(place)];
        if (heritage::is_of_two_bowls(settings.targets[row])) settings.rules.jars.push_back(place);
    }
    return settings;
}

Result<KioskSettings> load_settings(const std::string& config_file, const std::string& other_file) {
    auto settings = load_settings(config_file);
    if (settings || other_file.empty()) return settings;
    auto others = load_settings(other_file);
    if (!others) return others;
    others->remarks.insert(others->remarks.begin(), fmt::format("{}; going on with {} until it is mended",
                                                                settings.error().message, other_file));
    return others;
}

}  // namespace onggi::app

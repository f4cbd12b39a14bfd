// The settings of a kiosk at its start: configuration, languages, heritage pots. Main thread; blocks.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "game/heritage/target.h"
#include "game/kiosk/config.h"
#include "game/kiosk/strings.h"
#include "game/screens/page/view.h"

namespace onggi::app {

// The tick rate of the haptic loop, Hz: the configured rate, or for 0 a default, which is higher if the
// kernel grants real-time scheduling.
[[nodiscard]] constexpr double tick_rate_hz(double wanted_hz, bool keeps_deadlines) {
    constexpr double kRealTimeRateHz = 4000.0;
    constexpr double kPlainRateHz = 1000.0;
    return wanted_hz > 0.0 ? wanted_hz : keeps_deadlines ? kRealTimeRateHz : kPlainRateHz;
}

struct KioskSettings {
    kiosk::Config config;
    kiosk::Rules rules;
    std::shared_ptr<const std::vector<kiosk::Language>> languages;  // in the configuration's order
    std::vector<heritage::Target> targets;
    std::vector<std::size_t> exhibit_places;  // index into `targets` of each exhibit
    std::shared_ptr<const std::vector<screens::Exhibit>> exhibits;
    std::shared_ptr<const std::vector<screens::Exhibit>> relatives;  // all of `targets`, in their order
    std::vector<std::string> remarks;                                // problems that need not stop the start
};

// The folder of the program's own state: the visit in progress, the rest of an interrupted visit.
[[nodiscard]] inline std::filesystem::path state_folder(const std::filesystem::path& gallery) {
    return gallery / "state";
}
// The folder of the statistics and of the staff's settings.
[[nodiscard]] std::filesystem::path statistics_folder(const kiosk::Config& config);

// The defaults that the staff set for every visit. keep_house() stores them in that folder;
// take_kept_house() applies them at the next start if sound.remember_staff is set, and skips a language that
// the settings no longer list.
struct HouseDefaults {
    int volume = 3;        // 0 to kiosk::kMostVolume
    std::string language;  // code
};
Result<void> keep_house(const std::filesystem::path& folder, const HouseDefaults& house);
void take_kept_house(KioskSettings& settings);

// Checks a picture of that size on the configured panel and at the configured distance. Returns one line for
// each text that stays too small to read and each target too small to touch.
[[nodiscard]] std::vector<std::string> panel_lacks(const kiosk::Config& config, int width_px, int height_px);

// Errors as of files::read_file() and kiosk::read_config().
Result<kiosk::Config> read_config_file(const std::string& file);
// Returns defaults if `config_file` is empty. Bad input: an error in the file or in a table of its languages
// folder; a listed language that is neither built in nor has a table.
Result<KioskSettings> load_settings(const std::string& config_file);
// If `config_file` is invalid, falls back to `other_file` with a remark, so that a typing error does not
// leave the screen dark. Bad input: both are invalid, or the first is and `other_file` is empty.
Result<KioskSettings> load_settings(const std::string& config_file, const std::string& other_file);

}  // namespace onggi::app

// What a kiosk starts with: its configuration, its languages, its pots of museums. Main thread; blocks.
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

// How often the kiosk's wheel ticks: as the settings say (0: nothing), else at the finer rate where the
// kernel keeps deadlines for us. Hz.
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
    std::vector<std::size_t> exhibit_places;  // of each exhibit, in `targets`
    std::shared_ptr<const std::vector<screens::Exhibit>> exhibits;
    std::shared_ptr<const std::vector<screens::Exhibit>> relatives;  // all of `targets`, in their order
    std::vector<std::string> remarks;  // what is not as it should be, and does not matter enough to stop
};

// Where the wheel keeps what it needs itself: the visit in progress, what an interrupted one left.
[[nodiscard]] inline std::filesystem::path state_folder(const std::filesystem::path& gallery) {
    return gallery / "state";
}
// Where visits are counted, and what the staff has set is kept.
[[nodiscard]] std::filesystem::path statistics_folder(const kiosk::Config& config);

// What the staff has set for every visit to begin with, kept in that folder and, where the settings want it
// so, taken from there at the next start; a language that is no longer among the settings' is passed over.
struct HouseDefaults {
    int volume = 3;        // 0 to kiosk::kMostVolume
    std::string language;  // code
};
Result<void> keep_house(const std::filesystem::path& folder, const HouseDefaults& house);
void take_kept_house(KioskSettings& settings);

// What a picture of that size cannot keep on the panel and at the distance of the settings: a line each for
// words that stay too small to be read and targets that are too small to be touched.
[[nodiscard]] std::vector<std::string> panel_lacks(const kiosk::Config& config, int width_px, int height_px);

// Errors as of files::read_file() and kiosk::read_config().
Result<kiosk::Config> read_config_file(const std::string& file);
// `config_file` empty: defaults. Bad input: what the file, or a table of its languages folder, says wrong; a
// language of the order that neither is built in nor has a table.
Result<KioskSettings> load_settings(const std::string& config_file);
// A museum's typing error must not leave a visitor before a dark screen: where that file's settings cannot be
// used, those of `other_file`, and a remark that says so. Bad input: neither can; empty: there is no other.
Result<KioskSettings> load_settings(const std::string& config_file, const std::string& other_file);

}  // namespace onggi::app

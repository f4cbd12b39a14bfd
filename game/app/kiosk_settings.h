// What a kiosk starts with: its configuration, its languages, its pots of museums. Main thread; blocks.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "game/heritage/target.h"
#include "game/kiosk/config.h"
#include "game/kiosk/strings.h"
#include "game/screens/view.h"

namespace onggi::app {

struct KioskSettings {
    kiosk::Config config;
    kiosk::Rules rules;
    std::shared_ptr<const std::vector<kiosk::Language>> languages;  // in the configuration's order
    std::vector<heritage::Target> targets;
    std::vector<std::size_t> exhibit_places;  // of each exhibit, in `targets`
    std::shared_ptr<const std::vector<screens::Exhibit>> exhibits;
    std::vector<std::string> remarks;  // what is not as it should be, and does not matter enough to stop
};

// `config_file` empty: defaults. Bad input: what the file, or a table of its languages folder, says wrong; a
// language of the order that neither is built in nor has a table.
Result<KioskSettings> load_settings(const std::string& config_file);

}  // namespace onggi::app

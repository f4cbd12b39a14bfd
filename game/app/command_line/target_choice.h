// `throw --target`: a museum's pot to score a thrown one beside (target_score.h). Main thread; blocks.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "game/app/command_line/cli_names.h"
#include "game/heritage/target.h"

namespace onggi::app {

// All targets, and the one chosen; none: the nearest by shape, once the pot is there.
struct TargetChoice {
    std::vector<heritage::Target> targets;
    std::optional<std::size_t> chosen;
};

void add_target_option(CLI::App& command, std::optional<std::string>& id);

// Reads the targets from the assets where an id is given, "nearest" included. Bad input listing those known
// for another; system lacks where there are no assets.
[[nodiscard]] Result<std::optional<TargetChoice>> find_target_choice(const std::optional<std::string>& id);

}  // namespace onggi::app

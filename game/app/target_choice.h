// `throw --target`: a museum's pot to score a thrown one beside. Main thread; blocks.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "game/app/cli_names.h"
#include "game/clay/studio/studio_clay.h"
#include "game/heritage/score.h"

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

struct TargetScore {
    std::string text;  // for a person, a line a measure
    nlohmann::ordered_json json;
};
// Precondition: clay on the wheel.
[[nodiscard]] TargetScore score_beside(const TargetChoice& choice, const clay::StudioClay& clay);

}  // namespace onggi::app

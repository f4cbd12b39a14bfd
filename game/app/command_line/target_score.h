// A pot scored beside the museum's that was chosen, or that is nearest by shape. Main thread.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "game/app/command_line/target_choice.h"
#include "game/clay/studio/studio_clay.h"

namespace onggi::app {

struct TargetScore {
    std::string text;  // for a person, a line a measure
    nlohmann::ordered_json json;
};
// Precondition: clay on the wheel.
[[nodiscard]] TargetScore score_beside(const TargetChoice& choice, const clay::StudioClay& clay);

}  // namespace onggi::app

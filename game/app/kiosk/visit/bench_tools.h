// The tools that lie on the bench of the photographed room, as places to touch. Pure; main thread.
#pragma once

#include <optional>
#include <vector>

#include "game/app/kiosk/visit/visit_parts.h"
#include "game/screens/page/view.h"

namespace onggi::app {

// The rib is drawn there while nobody holds it; the others are in the photographs.
[[nodiscard]] bool rib_lies_there(const VisitParts& parts, const kiosk::State& state);

// Where they are seen now, each with room for a finger; none from above, where the bench is out of the
// picture.
[[nodiscard]] std::vector<screens::BenchTool> bench_tools(const VisitParts& parts, const kiosk::State& state);

// The one under a finger there.
[[nodiscard]] std::optional<tool::Tool> bench_tool_at(const std::vector<screens::BenchTool>& tools, vec2 px);

}  // namespace onggi::app

// The touch targets of the tools on the photographed room's bench. Pure; main thread.
#pragma once

#include <optional>
#include <vector>

#include "game/app/kiosk/visit/visit_parts.h"
#include "game/screens/page/view.h"

namespace onggi::app {

// Whether the rib is drawn on the bench: while it is not held. The other tools are in the photographs.
[[nodiscard]] bool rib_lies_there(const VisitParts& parts, const kiosk::State& state);

// The tools' places in the picture, each large enough for a finger; empty in the view from above, which does
// not show the bench.
[[nodiscard]] std::vector<screens::BenchTool> bench_tools(const VisitParts& parts, const kiosk::State& state);

// The tool at that place, if any.
[[nodiscard]] std::optional<tool::Tool> bench_tool_at(const std::vector<screens::BenchTool>& tools, vec2 px);

}  // namespace onggi::app

// The tools that lie on the bench of the photographed room, as places to touch. Pure; main thread.
#pragma once

#include <optional>
#include <vector>

#include "game/kiosk/state.h"
#include "game/screens/view.h"
#include "game/wheel/live_view.h"

namespace onggi::app {

// Where they are seen now, each with room for a finger; none from above, where the bench is out of the
// picture.
[[nodiscard]] std::vector<screens::BenchTool> bench_tools(const wheel::LiveView& view, bool looks_in);

// The one under a finger there.
[[nodiscard]] std::optional<kiosk::Held> bench_tool_at(const std::vector<screens::BenchTool>& tools, vec2 px);

}  // namespace onggi::app

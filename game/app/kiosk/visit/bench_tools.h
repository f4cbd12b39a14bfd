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

// A finger that taps slips by less, in units of the screens.
constexpr float kTapU = 24.0F;

// A touch that begins on a tool of the bench: a tap takes the tool, a drag is the hand's. slip_px: how far a
// tap may slip.
class BenchTouch {
  public:
    void begin(tool::Tool tool, vec2 px, float slip_px) { touch_ = Touch{tool, px, slip_px}; }
    // Returns true once the touch has become a drag; it is then over.
    [[nodiscard]] bool becomes_drag(vec2 px);
    // The finger is lifted: the tool to take, if the touch was a tap.
    [[nodiscard]] std::optional<tool::Tool> lift();

  private:
    struct Touch {
        tool::Tool tool;
        vec2 from_px;
        float slip_px;
    };
    std::optional<Touch> touch_;
};

// The tool at that place, if any.
[[nodiscard]] std::optional<tool::Tool> bench_tool_at(const std::vector<screens::BenchTool>& tools, vec2 px);

}  // namespace onggi::app

#include "game/app/kiosk/visit/bench_tools.h"

#include <array>

#include "game/screens/page/layout.h"
#include "game/wheel/tool_models.h"

namespace onggi::app {
namespace {

// As assets/workshop/maker/tools.py laid them, and the rib, in the wheel's frame: mm, +Y up, towards the
// visitor +Z.
struct Lying {
    tool::Tool held;
    dvec3 at_mm;
    vec2 size_u;
};
const std::array kLying{Lying{tool::Tool::kSponge, {300.0, -45.0, 45.0}, {112.0F, 94.0F}},
                        Lying{tool::Tool::kWire, {-325.0, -50.0, -128.0}, {250.0F, 78.0F}},
                        Lying{tool::Tool::kRib, wheel::kRibOnBenchMm, {80.0F, 130.0F}}};

// Whether that room is what visitors see: a museum's own has another bench.
bool has_bench(const VisitParts& parts) {
    return parts.settings.config.screen.room.empty() &&
           parts.view.project_framed(wheel::View::kThrowing, {}, dvec3(0.0)).has_value();
}

}  // namespace

bool rib_lies_there(const VisitParts& parts, const kiosk::State& state) {
    return state.throwing.held != tool::Tool::kRib && has_bench(parts);
}

std::vector<screens::BenchTool> bench_tools(const VisitParts& parts, const kiosk::State& state) {
    std::vector<screens::BenchTool> tools;
    if (state.throwing.looks_in || !has_bench(parts)) return tools;
    const wheel::LiveView& view = parts.view;
    const float px_per_u = screens::px_per_u_of(view.width(), view.height());
    for (const Lying& tool : kLying) {
        if (tool.held == tool::Tool::kRib && !rib_lies_there(parts, state)) continue;
        const auto px = view.project(tool.at_mm);
        if (!px) continue;
        tools.push_back({tool.held, glm::round(vec2(*px)), tool.size_u * px_per_u});
    }
    return tools;
}

std::optional<tool::Tool> bench_tool_at(const std::vector<screens::BenchTool>& tools, vec2 px) {
    for (const screens::BenchTool& tool : tools) {
        const vec2 off = glm::abs(px - tool.centre_px);
        if (off.x < 0.5F * tool.size_px.x && off.y < 0.5F * tool.size_px.y) return tool.held;
    }
    return std::nullopt;
}

}  // namespace onggi::app

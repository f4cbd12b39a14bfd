#include "game/app/kiosk/visit/bench_tools.h"

#include <utility>

#include "game/screens/page/layout.h"

namespace onggi::app {
namespace {

// Whether the scene is the program's own photographed room. A museum's room has another bench.
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
    wheel::LiveView& view = parts.view;
    const float px_per_u = screens::px_per_u_of(view.width(), view.height());
    view.scene().registry().each<wheel::BenchTool, wheel::Transform>(
        [&](ecs::Entity, const wheel::BenchTool& tool, const wheel::Transform& transform) {
            if (tool.tool == tool::Tool::kRib && !rib_lies_there(parts, state)) return;
            const auto px = view.project(transform.position_mm);
            if (px) tools.push_back({tool.tool, glm::round(vec2(*px)), tool.target_u * px_per_u});
        });
    return tools;
}

bool BenchTouch::becomes_drag(vec2 px) {
    if (!touch_ || glm::distance(px, touch_->from_px) < touch_->slip_px) return false;
    touch_.reset();
    return true;
}

std::optional<tool::Tool> BenchTouch::lift() {
    const auto touch = std::exchange(touch_, std::nullopt);
    return touch ? std::optional(touch->tool) : std::nullopt;
}

std::optional<tool::Tool> bench_tool_at(const std::vector<screens::BenchTool>& tools, vec2 px) {
    for (const screens::BenchTool& tool : tools) {
        const vec2 off = glm::abs(px - tool.centre_px);
        if (off.x < 0.5F * tool.size_px.x && off.y < 0.5F * tool.size_px.y) return tool.held;
    }
    return std::nullopt;
}

}  // namespace onggi::app

// The systems of hands and tools; see systems.h. Main thread.
#include <algorithm>
#include <span>

#include "game/wheel/systems.h"

namespace onggi::wheel {
namespace {

// Among the rings of the pot, the one at this height; heights as the pot has them.
std::size_t ring_at(const pot::Pot& pot, double height_mm) {
    const std::size_t count = pot.outer_mm.size();
    if (count == 0) return 0;
    std::size_t ring = 0;
    if (pot.top_mm.size() == count) {
        const auto above =
            std::upper_bound(pot.top_mm.begin(), pot.top_mm.end(), static_cast<float>(height_mm));
        ring = static_cast<std::size_t>(above - pot.top_mm.begin());
    } else {
        const double fraction = std::clamp(height_mm / std::max(pot.height_mm, 1e-6), 0.0, 1.0);
        ring = static_cast<std::size_t>(fraction * static_cast<double>(count));
    }
    return std::min(ring, count - 1);
}

double height_of(const pot::Pot& pot, std::size_t ring) {
    if (pot.top_mm.size() == pot.outer_mm.size()) return double{pot.top_mm[ring]};
    return pot.height_mm * (static_cast<double>(ring) + 1.0) / static_cast<double>(pot.outer_mm.size());
}

// How much wider a face is a mm higher up, over a span that leaves out the throwing rings.
double lean_at(const pot::Pot& pot, std::span<const float> face, double height_mm) {
    constexpr double kSpanMm = 9.0;
    if (face.empty()) return 0.0;
    const std::size_t below = ring_at(pot, height_mm - kSpanMm);
    const std::size_t above = ring_at(pot, height_mm + kSpanMm);
    const double rise = height_of(pot, above) - height_of(pot, below);
    return rise > 1.0 ? (double{face[above]} - double{face[below]}) / rise : 0.0;
}

double mouth_radius(const pot::Pot& pot) {
    return pot.inner_mm.empty() ? 0.0 : double{pot.inner_mm.back()};
}

ToolSight sight_of(const pot::Pot& pot, const HandView& hand, bool is_assistant) {
    const bool inside = hand.side == clay::studio::Side::kIn;
    return {
        .centre_mm = hand.position_mm,
        .radius_mm = hand.radius_mm,
        .kind = hand.tool,
        .side = hand.side,
        // Nobody's hand belongs in the kiln, nor to a pot that comes out of it. What is trimmed is dry.
        .shown = hand.shown && (pot.stage == clay::Firing::kWet || hand.tool == clay::StudioTool::kTrimmer),
        .touching = hand.touching,
        .wall_lean = lean_at(pot, inside ? pot.inner_mm : pot.outer_mm, hand.position_mm.y),
        .mouth_radius_mm = mouth_radius(pot),
        .is_assistant = is_assistant,
        .below_rim_mm = pot.height_mm - hand.position_mm.y,
        .guided = hand.guided,
        .digs = hand.digs};
}

}  // namespace

void receive_tools(ecs::Registry& registry, FrameContext& context) {
    const WheelView& shown = *context.shown;
    // The paper's clay is touched by the paper's ball; the studio's, whose rings have tops, by hands.
    const bool as_ball = shown.pot->top_mm.empty();
    registry.each<Tool>([&](ecs::Entity, Tool& tool) {
        const bool is_assistant = tool.sight.is_assistant;
        tool.sight = sight_of(*shown.pot, is_assistant ? shown.second_hand : shown.hand, is_assistant);
        tool.as_ball = as_ball;
    });
    registry.each<Wire>([&](ecs::Entity, Wire& wire) {
        wire.shown = shown.wire_shown;
        wire.height_mm = shown.wire_height_mm;
    });
    registry.each<OnBench>([&](ecs::Entity, OnBench& bench) { bench.rib = shown.rib_on_bench; });
}

void move_tools(ecs::Registry& registry, FrameContext& context) {
    registry.each<Tool>([&](ecs::Entity, Tool& tool) { tool.pose.follow(tool.sight, context.dt_s); });
}

void move_shavings(ecs::Registry& registry, FrameContext& context) {
    const WheelView& shown = *context.shown;
    bool moves_less = false;
    registry.each<PhotographedRoom>(
        [&](ecs::Entity, const PhotographedRoom& room) { moves_less = moves_less || room.moves_less; });
    registry.each<Shaved>([&](ecs::Entity, Shaved& shaved) {
        shaved.shavings.follow({.shaved_mm3 = shown.shaved_mm3,
                                .from_mm = shown.shaved_at_mm,
                                .wheel_speed_rad_s = shown.wheel_speed_rad_s},
                               context.dt_s, moves_less);
    });
}

void extract_tools(ecs::Registry& registry, FrameContext& context) {
    render::Scene& scene = context.scene;
    scene.spheres.clear();
    scene.props.clear();
    bool has_tools = false;
    registry.each<ToolShelf>([&](ecs::Entity, const ToolShelf& shelf) {
        scene.prop_library = shelf.library;
        has_tools = shelf.has_tools();
    });
    vec3 clay(0.3F);
    float wetness = 0.0F;
    registry.each<Clay>([&](ecs::Entity, const Clay& wet) {
        wetness = wet.wetness.empty() ? wet.material.wetness : wet.wetness.back();
        clay = wet.material.albedo * (1.0F - 0.4F * wetness);
    });
    const auto add = [&](ToolModel model, bool left, const mat4& place) {
        scene.props.push_back(
            {.model = library_place(model, left), .place = place, .smear = clay, .wetness = wetness});
    };
    registry.each<Tool>([&](ecs::Entity, const Tool& tool) {
        if (tool.as_ball || !has_tools) {
            if (!tool.sight.shown) return;
            const vec3 centre_mm(tool.sight.centre_mm);
            const auto radius_mm = static_cast<float>(tool.sight.radius_mm);
            add(ToolModel::kBall, false,
                glm::scale(glm::translate(mat4(1.0F), centre_mm), vec3(radius_mm / kBallRadiusMm)));
            scene.spheres.push_back({.centre_mm = centre_mm, .radius_mm = radius_mm});
            return;
        }
        const ToolPicture picture = tool.pose.picture();
        for (const ShownTool& shown : picture.tools)
            add(shown.model, shown.left, shown.place);
        scene.spheres.insert(scene.spheres.end(), picture.shadows.begin(), picture.shadows.end());
    });
    if (!has_tools) return;
    registry.each<OnBench>([&](ecs::Entity, const OnBench& bench) {
        constexpr double kTurnedRad = -0.35;  // against the cup
        constexpr double kLeansRad = 0.28;
        if (bench.rib) add(ToolModel::kRib, false, placed(kRibOnBenchMm, kTurnedRad, kLeansRad));
    });
    registry.each<Shaved>([&](ecs::Entity, const Shaved& shaved) {
        for (const mat4& place : shaved.shavings.places())
            add(ToolModel::kCurl, false, place);
    });
    registry.each<Wire>([&](ecs::Entity, const Wire& wire) {
        if (!wire.shown) return;
        // Across the picture, so that it is seen to pass under the pot.
        constexpr double kAcross = 1.5707963267948966;
        add(ToolModel::kWire, false, placed({0.0, wire.height_mm, 0.0}, kAcross, 0.0));
    });
}

}  // namespace onggi::wheel

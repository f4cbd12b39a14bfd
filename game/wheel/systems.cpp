#include "game/wheel/systems.h"

#include <algorithm>
#include <cmath>

namespace onggi::wheel {

void receive_clay(ecs::Registry& registry, FrameContext& context) {
    registry.each<Clay>([&](ecs::Entity, Clay& clay) {
        clay.radii_mm.assign(context.pot->radii_mm.begin(), context.pot->radii_mm.end());
        clay.height_mm = context.pot->height_mm;
    });
}

void receive_wheel(ecs::Registry& registry, FrameContext& context) {
    registry.each<Wheel>([&](ecs::Entity, Wheel& wheel) {
        wheel.direction = context.pot->wheel_direction;
        wheel.turning = context.pot->wheel_turning;
    });
}

void receive_tool(ecs::Registry& registry, FrameContext& context) {
    registry.each<Tool, Transform>([&](ecs::Entity, Tool& tool, Transform& transform) {
        transform.position_mm = context.pot->tool_position_mm;
        tool.radius_mm = context.pot->tool_radius_mm;
        tool.shown = context.pot->tool_shown;
        tool.touching = context.pot->contacts > 0;
    });
}

void extract_camera(ecs::Registry& registry, FrameContext& context) {
    registry.each<CameraRig>([&](ecs::Entity, const CameraRig& rig) {
        context.scene.camera = camera_of(rig, context.width_px, context.height_px);
    });
}

void extract_light(ecs::Registry& registry, FrameContext& context) {
    registry.each<KeyLight>([&](ecs::Entity, const KeyLight& key) { context.scene.key = key.light; });
    registry.each<Surroundings>([&](ecs::Entity, const Surroundings& surroundings) {
        context.scene.environment = surroundings.environment;
        context.scene.backdrop = surroundings.backdrop;
    });
}

void extract_still_life(ecs::Registry& registry, FrameContext& context) {
    // Gathered once: nothing adds to it or moves it, and the renderer keeps what it has uploaded.
    if (context.scene.still_life) return;
    auto still_life = std::make_shared<render::StillLife>();
    registry.each<StillPart, Transform>([&](ecs::Entity, const StillPart& part, const Transform& transform) {
        still_life->parts.push_back({.mesh = part.mesh,
                                     .material = part.material,
                                     .position_mm = vec3(transform.position_mm),
                                     .casts_shadow = part.casts_shadow});
    });
    still_life->revision = 1;
    context.scene.still_life = std::move(still_life);
}

void extract_clay(ecs::Registry& registry, FrameContext& context) {
    context.scene.lathe.reset();
    registry.each<Clay, Wheel>([&](ecs::Entity, const Clay& clay, const Wheel& wheel) {
        if (clay.radii_mm.empty()) return;
        context.scene.lathe = render::Lathe{.radii_mm = clay.radii_mm,
                                            .element_height_mm = static_cast<float>(
                                                clay.height_mm / static_cast<double>(clay.radii_mm.size())),
                                            .edge_rounding_mm = clay.edge_rounding_mm,
                                            .turn = vec2(wheel.direction),
                                            .material = clay.material};
    });
}

void extract_tools(ecs::Registry& registry, FrameContext& context) {
    context.scene.spheres.clear();
    registry.each<Tool, Transform>([&](ecs::Entity, const Tool& tool, const Transform& transform) {
        if (!tool.shown) return;
        context.scene.spheres.push_back({.centre_mm = vec3(transform.position_mm),
                                         .radius_mm = static_cast<float>(tool.radius_mm),
                                         .material = tool.material});
    });
}

ecs::Schedule<FrameContext> wheel_schedule() {
    ecs::Schedule<FrameContext> schedule;
    schedule.add(ecs::Phase::kReceive, "receive clay", receive_clay)
        .add(ecs::Phase::kReceive, "receive wheel", receive_wheel)
        .add(ecs::Phase::kReceive, "receive tool", receive_tool)
        .add(ecs::Phase::kExtract, "extract camera", extract_camera)
        .add(ecs::Phase::kExtract, "extract light", extract_light)
        .add(ecs::Phase::kExtract, "extract still life", extract_still_life)
        .add(ecs::Phase::kExtract, "extract clay", extract_clay)
        .add(ecs::Phase::kExtract, "extract tools", extract_tools);
    return schedule;
}

render::Camera camera_of(const CameraRig& rig, int width_px, int height_px) {
    const double aspect = static_cast<double>(width_px) / static_cast<double>(height_px);
    // A narrow picture steps back (in angle, not in place, so that its perspective stays) until the width
    // fits.
    const double shown_height_mm = std::max(rig.height_mm, rig.width_mm / aspect);
    const double flat = rig.distance_mm * std::cos(rig.elevation_rad);
    const dvec3 from_target(flat * std::sin(rig.azimuth_rad), rig.distance_mm * std::sin(rig.elevation_rad),
                            flat * std::cos(rig.azimuth_rad));
    return {.eye_mm = vec3(rig.target_mm + from_target),
            .target_mm = vec3(rig.target_mm),
            .vertical_fov_rad = static_cast<float>(2.0 * std::atan(0.5 * shown_height_mm / rig.distance_mm)),
            .near_mm = static_cast<float>(0.2 * rig.distance_mm),
            .far_mm = static_cast<float>(6.0 * rig.distance_mm)};
}

}  // namespace onggi::wheel

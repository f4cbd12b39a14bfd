#include "game/wheel/systems.h"

#include <algorithm>
#include <cmath>

namespace onggi::wheel {

void receive_wheel(ecs::Registry& registry, FrameContext& context) {
    registry.each<Wheel>([&](ecs::Entity, Wheel& wheel) {
        wheel.direction = context.shown->wheel_direction;
        wheel.turning = context.shown->wheel_turning;
    });
}

void pass_time_of_day(ecs::Registry& registry, FrameContext& context) {
    registry.each<TimeOfDay>([&](ecs::Entity, TimeOfDay& time) {
        constexpr double kRatePerS = 3.0;
        time.now = settled(time.now, time.evening, kRatePerS, context.dt_s);
        // A step of the eight bits, and no more layers are drawn for it.
        const bool is_there =
            std::abs(time.now.value - time.evening) < 2e-3 && std::abs(time.now.speed) < 1e-2;
        if (is_there || context.dt_s == 0.0) time.now = {.value = time.evening, .speed = 0.0};
    });
}

void extract_light(ecs::Registry& registry, FrameContext& context) {
    registry.each<TimeOfDay>(
        [&](ecs::Entity, const TimeOfDay& time) { context.scene.levels = light_levels(time.now.value); });
    registry.each<KeyLight>([&](ecs::Entity, const KeyLight& key) { context.scene.key = key.light; });
    registry.each<Surroundings>([&](ecs::Entity, const Surroundings& surroundings) {
        context.scene.environment = surroundings.environment;
        context.scene.irradiance = surroundings.irradiance;
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

ecs::Schedule<FrameContext> wheel_schedule() {
    ecs::Schedule<FrameContext> schedule;
    schedule.add(ecs::Phase::kReceive, "receive clay", receive_clay)
        .add(ecs::Phase::kReceive, "receive wheel", receive_wheel)
        .add(ecs::Phase::kReceive, "receive tools", receive_tools)
        .add(ecs::Phase::kAnimate, "move tools", move_tools)
        .add(ecs::Phase::kAnimate, "move shavings", move_shavings)
        .add(ecs::Phase::kAnimate, "move camera", move_camera)
        .add(ecs::Phase::kAnimate, "pass time of day", pass_time_of_day)
        .add(ecs::Phase::kExtract, "extract camera", extract_camera)
        .add(ecs::Phase::kExtract, "extract light", extract_light)
        .add(ecs::Phase::kExtract, "extract still life", extract_still_life)
        .add(ecs::Phase::kExtract, "extract clay", extract_clay)
        .add(ecs::Phase::kExtract, "extract tools", extract_tools);
    return schedule;
}

render::LightLevels light_levels(double evening) {
    const auto fraction = static_cast<float>(std::clamp(evening, 0.0, 1.0));
    constexpr vec3 kEveningAmbient(0.36F, 0.30F, 0.26F);
    constexpr float kEveningKey = 0.30F;
    return {.ambient = glm::mix(vec3(1.0F), kEveningAmbient, fraction),
            .key = 1.0F + (kEveningKey - 1.0F) * fraction};
}

}  // namespace onggi::wheel

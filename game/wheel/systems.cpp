#include "game/wheel/systems.h"

#include <algorithm>
#include <cmath>

namespace onggi::wheel {
namespace {

constexpr double kSwayRad = 0.021;     // a little over a degree
constexpr double kSwayZoom = 0.045;    // nearer by that, so that nothing from outside the plate comes in
constexpr double kSwayRadPerS = 0.21;  // half a minute there and back

render::Camera framed(const render::Plate& plate, const Framing& framing, int width_px, int height_px) {
    return framed(render::plate_camera(plate.camera, plate.width_px, plate.height_px, width_px, height_px),
                  framing);
}

}  // namespace

render::Camera framed(const render::Camera& camera, const Framing& framing) {
    render::Camera shown = render::zoomed(camera, framing.zoom);
    shown.lens_shift = vec2(framing.shift);
    return shown;
}

void receive_wheel(ecs::Registry& registry, FrameContext& context) {
    registry.each<Wheel>([&](ecs::Entity, Wheel& wheel) {
        wheel.direction = context.pot->wheel_direction;
        wheel.turning = context.pot->wheel_turning;
    });
}

void move_camera(ecs::Registry& registry, FrameContext& context) {
    registry.each<PhotographedRoom>([&](ecs::Entity, PhotographedRoom& room) {
        const ShownPlate goal = shown_plate(room, context.width_px, context.height_px);
        if (goal.camera == nullptr) return;
        const CameraPose pose =
            pose_of(framed(*goal.plate, room.framing, context.width_px, context.height_px));
        const bool is_same_size = context.width_px == room.width_px && context.height_px == room.height_px;
        const bool is_known = room.plates.contains(room.from) && room.plates.contains(room.to);
        if (!is_known || !is_same_size) {
            room.motion.jump_to(pose);
            room.from = room.to = goal.camera->name;
            room.width_px = context.width_px;
            room.height_px = context.height_px;
        } else if (goal.camera->name != room.to && goal.camera->name != room.from) {
            room.from = room.to;
            room.to = goal.camera->name;
        } else if (room.from == room.to) {
            room.to = goal.camera->name;
        }
        if (context.dt_s > 0.0 && !room.jumps) {
            room.motion.go_to(pose);
            room.motion.advance(context.dt_s);
        } else {
            room.motion.jump_to(pose);
        }
        if (room.motion.at_rest()) room.from = room.to = goal.camera->name;

        constexpr double kSwayRatePerS = 1.5;
        room.sway_share = settled(room.sway_share, room.sways ? 1.0 : 0.0, kSwayRatePerS, context.dt_s);
        if (room.jumps) room.sway_share = {.value = room.sways ? 1.0 : 0.0};
        room.jumps = false;
        if (!room.sways && room.sway_share.value < 1e-3) room.sway_share = {};
        room.sway_s = room.sway_share.value > 0.0 || room.sways ? room.sway_s + context.dt_s : 0.0;
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

void extract_camera(ecs::Registry& registry, FrameContext& context) {
    context.scene.plate.reset();
    registry.each<CameraRig>([&](ecs::Entity, const CameraRig& rig) {
        context.scene.camera = camera_of(rig, context.width_px, context.height_px);
    });
    context.scene.glide.reset();
    context.scene.plates_at_hand.clear();
    registry.each<PhotographedRoom>([&](ecs::Entity, const PhotographedRoom& room) {
        if (room.plates.empty()) {
            // Modelled, not photographed: from the same places.
            const PlateCamera* place =
                room.workshop->camera_for(room.view, context.width_px, context.height_px);
            if (place == nullptr) return;
            context.scene.camera =
                framed(render::plate_camera(place->camera, place->width_px, place->height_px,
                                            context.width_px, context.height_px),
                       room.framing);
            return;
        }
        for (const auto& [name, plate] : room.plates)
            context.scene.plates_at_hand.push_back(plate);
        const auto from = room.plates.find(room.from);
        const auto to = room.plates.find(room.to);
        if (from == room.plates.end() || to == room.plates.end()) return;
        context.scene.plate = from->second;
        const CameraPose pose = room.motion.pose();
        const double sway = room.sway_share.value * std::sin(room.sway_s * kSwayRadPerS);
        if (room.from == room.to && room.motion.at_rest() && room.sway_share.value == 0.0) {
            context.scene.camera = framed(*from->second, room.framing, context.width_px, context.height_px);
            return;
        }
        CameraPose swayed = pose;
        swayed.azimuth_rad += kSwayRad * sway;
        swayed.vertical_fov_rad *= 1.0 - kSwayZoom * room.sway_share.value;
        context.scene.camera = camera_at(swayed);
        const auto pose_from =
            pose_of(framed(*from->second, room.framing, context.width_px, context.height_px));
        const auto pose_to = pose_of(framed(*to->second, room.framing, context.width_px, context.height_px));
        context.scene.glide = render::Glide{
            .towards = to->second, .share = static_cast<float>(share_between(pose_from, pose_to, pose))};
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
                                     .bent_mesh = part.bent_mesh,
                                     .in_relief = part.in_relief,
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
        .add(ecs::Phase::kAnimate, "move camera", move_camera)
        .add(ecs::Phase::kAnimate, "pass time of day", pass_time_of_day)
        .add(ecs::Phase::kExtract, "extract camera", extract_camera)
        .add(ecs::Phase::kExtract, "extract light", extract_light)
        .add(ecs::Phase::kExtract, "extract still life", extract_still_life)
        .add(ecs::Phase::kExtract, "extract clay", extract_clay)
        .add(ecs::Phase::kExtract, "extract tools", extract_tools);
    return schedule;
}

ShownPlate shown_plate(const PhotographedRoom& room, int width_px, int height_px) {
    if (!room.workshop) return {};
    const auto loaded = [&](const PlateCamera& camera) -> ShownPlate {
        const auto found = room.plates.find(camera.name);
        return found == room.plates.end() ? ShownPlate{} : ShownPlate{&camera, found->second};
    };
    const PlateCamera* nearest = room.workshop->camera_for(room.view, width_px, height_px);
    if (nearest == nullptr) nearest = room.workshop->camera_for(View::kThrowing, width_px, height_px);
    if (const ShownPlate shown = loaded(*nearest); shown.camera != nullptr) return shown;
    for (const PlateCamera& camera : room.workshop->cameras) {
        if (!camera.name.starts_with(name_of(room.view))) continue;
        if (const ShownPlate shown = loaded(camera); shown.camera != nullptr) return shown;
    }
    return {};
}

render::LightLevels light_levels(double evening) {
    const auto share = static_cast<float>(std::clamp(evening, 0.0, 1.0));
    constexpr vec3 kEveningAmbient(0.36F, 0.30F, 0.26F);
    constexpr float kEveningKey = 0.30F;
    return {.ambient = glm::mix(vec3(1.0F), kEveningAmbient, share),
            .key = 1.0F + (kEveningKey - 1.0F) * share};
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

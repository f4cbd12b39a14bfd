// The camera's part of a frame: how it comes to another view, and what the scene shows of it.
#include <algorithm>
#include <cmath>

#include "game/wheel/systems.h"

namespace onggi::wheel {
namespace {

constexpr double kSwayRad = 0.021;     // a little over a degree
constexpr double kSwayZoom = 0.045;    // nearer by that, so that nothing from outside the plate comes in
constexpr double kSwayRadPerS = 0.21;  // half a minute there and back

constexpr double kFadeS = 0.25;

render::Camera framed(const render::Plate& plate, const Framing& framing, int width_px, int height_px) {
    return framed(render::plate_camera(plate.camera, plate.width_px, plate.height_px, width_px, height_px),
                  framing);
}

// What the view that is wanted shows in a picture of this size.
struct Goal {
    const std::string& camera;
    CameraPose pose;
};

void stand_at(PhotographedRoom& room, const Goal& goal) {
    room.motion.jump_to(goal.pose);
    room.from = room.to = goal.camera;
    room.framed_so = room.framing;
    room.next.reset();
}

void sway(PhotographedRoom& room, double dt_s) {
    constexpr double kSwayRatePerS = 1.5;
    room.sway_share = settled(room.sway_share, room.sways ? 1.0 : 0.0, kSwayRatePerS, dt_s);
    if (room.jumps || room.moves_less) room.sway_share = {.value = room.sways ? 1.0 : 0.0};
    if (!room.sways && room.sway_share.value < 1e-3) room.sway_share = {};
    room.sway_s = room.sway_share.value > 0.0 || room.sways ? room.sway_s + dt_s : 0.0;
}

void glide(PhotographedRoom& room, const Goal& goal, double dt_s) {
    room.next.reset();
    room.fade_left_s = 0.0;
    if (goal.camera != room.to && goal.camera != room.from) {
        room.from = room.to;
        room.to = goal.camera;
    } else if (room.from == room.to) {
        room.to = goal.camera;
    }
    room.motion.go_to(goal.pose);
    room.motion.advance(dt_s);
    room.framed_so = room.framing;
    if (room.motion.at_rest()) stand_at(room, goal);
}

// What is left of a fade a frame later; so little that nobody sees it is nothing.
double fade_left(double left_s, double dt_s) {
    constexpr double kUnseenS = 1e-3;
    return left_s - dt_s > kUnseenS ? left_s - dt_s : 0.0;
}

// Between two frames it is there, as soon as the picture is: until then it stays.
void cut(PhotographedRoom& room, const Goal& goal, double dt_s) {
    room.fade_left_s = fade_left(room.fade_left_s, dt_s);
    if (goal.camera == room.from && room.framing == room.framed_so) {
        room.next.reset();
        return;
    }
    const ViewPlace wanted{goal.camera, room.framing};
    if (room.next != wanted) {
        room.next = wanted;
        return;
    }
    if (!room.next_is_ready) return;
    stand_at(room, goal);
    room.fade_left_s = room.moves_less ? 0.0 : fade_left(kFadeS, dt_s);
}

}  // namespace

render::Camera framed(const render::Camera& camera, const Framing& framing) {
    render::Camera shown = render::zoomed(camera, framing.zoom);
    shown.lens_shift = vec2(framing.shift);
    return shown;
}

void move_camera(ecs::Registry& registry, FrameContext& context) {
    registry.each<PhotographedRoom>([&](ecs::Entity, PhotographedRoom& room) {
        const ShownPlate plate = shown_plate(room, context.width_px, context.height_px);
        if (plate.camera == nullptr) return;
        const Goal goal{plate.camera->name,
                        pose_of(framed(*plate.plate, room.framing, context.width_px, context.height_px))};
        const bool is_same_size = context.width_px == room.width_px && context.height_px == room.height_px;
        const bool is_known = room.plates.contains(room.from) && room.plates.contains(room.to);
        const bool is_cut = !room.glides || room.moves_less;
        const bool stops_gliding = is_cut && !(room.motion.at_rest() && room.from == room.to);
        if (!is_known || !is_same_size || stops_gliding || room.jumps || context.dt_s <= 0.0) {
            stand_at(room, goal);
            room.width_px = context.width_px;
            room.height_px = context.height_px;
            room.fade_left_s = 0.0;
        } else if (is_cut) {
            cut(room, goal, context.dt_s);
        } else {
            glide(room, goal, context.dt_s);
        }
        room.next_is_ready = false;
        sway(room, context.dt_s);
        room.jumps = false;
    });
}

void extract_camera(ecs::Registry& registry, FrameContext& context) {
    render::Scene& scene = context.scene;
    const auto in_picture = [&](const render::Plate& plate, const Framing& framing) {
        return framed(plate, framing, context.width_px, context.height_px);
    };
    scene.plate.reset();
    registry.each<CameraRig>([&](ecs::Entity, const CameraRig& rig) {
        scene.camera = camera_of(rig, context.width_px, context.height_px);
    });
    scene.glide.reset();
    scene.next_view.reset();
    scene.fade_in.reset();
    scene.plates_at_hand.clear();
    registry.each<PhotographedRoom>([&](ecs::Entity, const PhotographedRoom& room) {
        if (room.plates.empty()) {
            // Modelled, not photographed: from the same places.
            const PlateCamera* place =
                room.workshop->camera_for(room.view, context.width_px, context.height_px);
            if (place == nullptr) return;
            scene.camera = framed(render::plate_camera(place->camera, place->width_px, place->height_px,
                                                       context.width_px, context.height_px),
                                  room.framing);
            return;
        }
        for (const auto& [name, plate] : room.plates)
            scene.plates_at_hand.push_back(plate);
        const auto from = room.plates.find(room.from);
        const auto to = room.plates.find(room.to);
        if (from == room.plates.end() || to == room.plates.end()) return;
        scene.plate = from->second;
        if (room.from == room.to && room.motion.at_rest() && room.sway_share.value == 0.0) {
            scene.camera = in_picture(*from->second, room.framed_so);
            if (room.next) {
                const auto next = room.plates.find(room.next->camera);
                if (next != room.plates.end()) {
                    scene.next_view =
                        render::NextView{in_picture(*next->second, room.next->framing), next->second};
                }
            }
            if (room.fade_left_s > 0.0) scene.fade_in = static_cast<float>(1.0 - room.fade_left_s / kFadeS);
            return;
        }
        const CameraPose pose = room.motion.pose();
        const double sway = room.sway_share.value * std::sin(room.sway_s * kSwayRadPerS);
        CameraPose swayed = pose;
        swayed.azimuth_rad += kSwayRad * sway;
        swayed.vertical_fov_rad *= 1.0 - kSwayZoom * room.sway_share.value;
        scene.camera = camera_at(swayed);
        const auto pose_from = pose_of(in_picture(*from->second, room.framing));
        const auto pose_to = pose_of(in_picture(*to->second, room.framing));
        scene.glide = render::Glide{.towards = to->second,
                                    .share = static_cast<float>(share_between(pose_from, pose_to, pose))};
    });
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

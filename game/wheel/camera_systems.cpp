// The camera's part of a frame: how it comes to another view, and what the scene shows of it.
#include <algorithm>
#include <cmath>

#include "game/wheel/systems.h"

namespace onggi::wheel {
namespace {

// An idle wheel's picture drifts a little: nearer, so that nothing from outside the photograph comes in, and
// from side to side.
constexpr double kSwayZoom = 0.045;
constexpr double kSwayShift = 0.04;    // halves of the picture
constexpr double kSwayRadPerS = 0.21;  // half a minute there and back

constexpr double kFadeS = 0.25;

render::Camera framed(const render::Background& background, const Framing& framing, int width_px,
                      int height_px) {
    return framed(render::background_camera(background.camera, background.width_px, background.height_px,
                                            width_px, height_px),
                  framing);
}

void stand_at(PhotographedRoom& room, const std::string& camera) {
    room.camera = camera;
    room.framed_so = room.framing;
    room.next.reset();
}

void sway(PhotographedRoom& room, double dt_s) {
    constexpr double kSwayRatePerS = 1.5;
    room.sway_fraction = settled(room.sway_fraction, room.sways ? 1.0 : 0.0, kSwayRatePerS, dt_s);
    if (room.jumps || room.moves_less) room.sway_fraction = {.value = room.sways ? 1.0 : 0.0};
    if (!room.sways && room.sway_fraction.value < 1e-3) room.sway_fraction = {};
    room.sway_s = room.sway_fraction.value > 0.0 || room.sways ? room.sway_s + dt_s : 0.0;
}

Framing swayed(const PhotographedRoom& room) {
    const double fraction = room.sway_fraction.value;
    Framing framing = room.framed_so;
    framing.zoom *= 1.0 + kSwayZoom * fraction;
    framing.shift.x += kSwayShift * fraction * std::sin(room.sway_s * kSwayRadPerS);
    return framing;
}

// What is left of a fade a frame later; so little that nobody sees it is nothing.
double fade_left(double left_s, double dt_s) {
    constexpr double kUnseenS = 1e-3;
    return left_s - dt_s > kUnseenS ? left_s - dt_s : 0.0;
}

// Between two frames it is there, as soon as the picture is: until then it stays.
void cut(PhotographedRoom& room, const std::string& camera, double dt_s) {
    room.fade_left_s = fade_left(room.fade_left_s, dt_s);
    if (camera == room.camera && room.framing == room.framed_so) {
        room.next.reset();
        return;
    }
    const ViewPlace wanted{camera, room.framing};
    if (room.next != wanted) {
        room.next = wanted;
        return;
    }
    if (!room.next_is_ready) return;
    stand_at(room, camera);
    room.fade_left_s = room.moves_less ? 0.0 : fade_left(kFadeS, dt_s);
}

}  // namespace

void move_camera(ecs::Registry& registry, FrameContext& context) {
    registry.each<PhotographedRoom>([&](ecs::Entity, PhotographedRoom& room) {
        const ShownBackground background = shown_background(room, context.width_px, context.height_px);
        if (background.camera == nullptr) return;
        const std::string& camera = background.camera->name;
        const bool is_same_size = context.width_px == room.width_px && context.height_px == room.height_px;
        const bool is_known = room.backgrounds.contains(room.camera);
        if (!is_known || !is_same_size || room.jumps || context.dt_s <= 0.0) {
            stand_at(room, camera);
            room.width_px = context.width_px;
            room.height_px = context.height_px;
            room.fade_left_s = 0.0;
        } else {
            cut(room, camera, context.dt_s);
        }
        room.next_is_ready = false;
        sway(room, context.dt_s);
        room.jumps = false;
    });
}

void extract_camera(ecs::Registry& registry, FrameContext& context) {
    render::Scene& scene = context.scene;
    const auto in_picture = [&](const render::Background& background, const Framing& framing) {
        return framed(background, framing, context.width_px, context.height_px);
    };
    scene.background.reset();
    registry.each<CameraRig>([&](ecs::Entity, const CameraRig& rig) {
        scene.camera = camera_of(rig, context.width_px, context.height_px);
    });
    scene.next_view.reset();
    scene.fade_in.reset();
    scene.backgrounds_at_hand.clear();
    registry.each<PhotographedRoom>([&](ecs::Entity, const PhotographedRoom& room) {
        if (room.backgrounds.empty()) {
            // Modelled, not photographed: from the same places.
            const BackgroundCamera* place =
                room.workshop->camera_for(room.view, context.width_px, context.height_px);
            if (place == nullptr) return;
            scene.camera = framed(render::background_camera(place->camera, place->width_px, place->height_px,
                                                            context.width_px, context.height_px),
                                  room.framing);
            return;
        }
        for (const auto& [name, background] : room.backgrounds)
            scene.backgrounds_at_hand.push_back(background);
        const auto shown = room.backgrounds.find(room.camera);
        if (shown == room.backgrounds.end()) return;
        scene.background = shown->second;
        scene.camera = in_picture(*shown->second, swayed(room));
        if (room.next) {
            const auto next = room.backgrounds.find(room.next->camera);
            if (next != room.backgrounds.end()) {
                scene.next_view =
                    render::NextView{in_picture(*next->second, room.next->framing), next->second};
            }
        }
        if (room.fade_left_s > 0.0) scene.fade_in = static_cast<float>(1.0 - room.fade_left_s / kFadeS);
    });
}

ShownBackground shown_background(const PhotographedRoom& room, int width_px, int height_px) {
    if (!room.workshop) return {};
    const auto loaded = [&](const BackgroundCamera& camera) -> ShownBackground {
        const auto found = room.backgrounds.find(camera.name);
        return found == room.backgrounds.end() ? ShownBackground{} : ShownBackground{&camera, found->second};
    };
    const BackgroundCamera* nearest = room.workshop->camera_for(room.view, width_px, height_px);
    if (nearest == nullptr) nearest = room.workshop->camera_for(View::kThrowing, width_px, height_px);
    if (const ShownBackground shown = loaded(*nearest); shown.camera != nullptr) return shown;
    for (const BackgroundCamera& camera : room.workshop->cameras) {
        if (!camera.name.starts_with(name_of(room.view))) continue;
        if (const ShownBackground shown = loaded(camera); shown.camera != nullptr) return shown;
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

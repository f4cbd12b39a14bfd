#include "game/wheel/systems.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "game/wheel/clay_look.h"

namespace onggi::wheel {
namespace {

// An idle wheel's picture drifts: slightly closer, so that no area outside the photograph is shown, and from
// side to side.
constexpr double kSwayZoom = 0.045;
constexpr double kSwayShift = 0.04;    // half pictures
constexpr double kSwayRadPerS = 0.21;  // half a minute for a period

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

// Time left in a fade after a frame; a remainder too short to see counts as 0.
double fade_left(double left_s, double dt_s) {
    constexpr double kUnseenS = 1e-3;
    return left_s - dt_s > kUnseenS ? left_s - dt_s : 0.0;
}

// Cuts to another view between two frames, as soon as its picture is ready. The old view stays until then.
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

// The index of the pot's ring at this height.
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

// Slope dR/dy of a face, over a span that averages out the throwing rings.
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
    const bool inside = hand.side == tool::Side::kIn;
    return {.centre_mm = hand.position_mm,
            .radius_mm = hand.radius_mm,
            .kind = hand.tool,
            .side = hand.side,
            // The kiln and its pots show no hand. Trimming works on dry clay, so the trimmer stays.
            .shown = hand.shown && (pot.stage == clay::Firing::kWet || hand.tool == tool::Tool::kTrimmer),
            .touching = hand.touching,
            .wall_lean = lean_at(pot, inside ? pot.inner_mm : pot.outer_mm, hand.position_mm.y),
            .mouth_radius_mm = mouth_radius(pot),
            .is_assistant = is_assistant,
            .below_rim_mm = pot.height_mm - hand.position_mm.y,
            .guided = hand.guided,
            .digs = hand.digs};
}

}  // namespace

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
        // Within one 8-bit step of the goal the level is set exactly, so that no further layers are drawn.
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
    // Collected once: the still life never changes, and the renderer keeps its uploads.
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

// The clay: the pot on the wheel becomes the lathe that is drawn.

void receive_clay(ecs::Registry& registry, FrameContext& context) {
    const pot::Pot& pot = *context.shown->pot;
    registry.each<Clay>([&](ecs::Entity, Clay& clay) {
        clay.pot = &pot;
        const render::LatheMaterial* own = context.shown->material;
        clay.material = own != nullptr ? *own : clay_material(pot.body, pot.stage);
        clay.marks = context.shown->marks;
        clay.wetness.clear();
        // Dry clay has no water left, whatever it had when it was thrown.
        if (pot.stage != clay::Firing::kWet) return;
        clay.wetness.resize(pot.liquidity.size());
        std::transform(pot.liquidity.begin(), pot.liquidity.end(), clay.wetness.begin(), darkness_of);
    });
}

void extract_clay(ecs::Registry& registry, FrameContext& context) {
    context.scene.lathe.reset();
    registry.each<Clay, Wheel>([&](ecs::Entity, const Clay& clay, const Wheel& wheel) {
        const pot::Pot& pot = *clay.pot;
        if (pot.outer_mm.empty()) return;
        render::Lathe lathe{
            .radii_mm = pot.outer_mm,
            .inner_mm = pot.inner_mm,
            .top_mm = pot.top_mm,
            .centre_mm = pot.centre_mm,
            .wetness = clay.wetness,
            .load = pot.load_index,
            .dents_mm = pot.dents_mm,
            .element_height_mm = static_cast<float>(pot.height_mm / static_cast<double>(pot.ring_count())),
            .edge_rounding_mm = clay.edge_rounding_mm,
            .turn = vec2(wheel.direction),
            .material = clay.material,
            .shows_load = clay.shows_load,
            .marks = clay.marks};
        if (pot.stage == clay::Firing::kWet) lathe.film = pot.film;
        if (clay.is_cut_open) {
            const vec3& eye = context.scene.camera.eye_mm;
            lathe.cut = render::LatheCut{.towards_rad = std::atan2(eye.x, eye.z),
                                         .section = section_colour(lathe.material)};
        }
        context.scene.lathe = lathe;
    });
}

// The camera: cuts between views, and the scene's camera.

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
            // A modelled room without photographs is seen from the same cameras.
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
    // A narrow picture widens its angle until the width fits; the camera stays in place to keep the
    // perspective.
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

// Hands and tools.

void receive_tools(ecs::Registry& registry, FrameContext& context) {
    const WheelView& shown = *context.shown;
    // The paper's clay is shown with the paper's ball; the studio's clay, whose rings have tops, with hands.
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
        constexpr double kAcross = 0.5 * kPi;
        add(ToolModel::kWire, false, placed({0.0, wire.height_mm, 0.0}, kAcross, 0.0));
    });
}

}  // namespace onggi::wheel

#include "game/wheel/wheel_scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "engine/files/asset_folder.h"
#include "engine/render/camera.h"
#include "game/pot/set_aside.h"
#include "game/wheel/clay_look.h"
#include "game/wheel/hands.h"
#include "game/wheel/tool_models.h"
#include "game/wheel/workshop.h"

namespace onggi::wheel {

render::LightLevels light_levels(double evening) {
    const auto fraction = static_cast<float>(std::clamp(evening, 0.0, 1.0));
    constexpr vec3 kEveningAmbient(0.36F, 0.30F, 0.26F);
    constexpr float kEveningKey = 0.30F;
    return {.ambient = glm::mix(vec3(1.0F), kEveningAmbient, fraction),
            .key = 1.0F + (kEveningKey - 1.0F) * fraction};
}

namespace {

// The systems of a frame. Each reads the snapshot and its components, advances its animations, and writes its
// part of the scene to draw.

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

// The background for a picture of this aspect ratio, and the camera that took it: the nearest ratio if it is
// loaded, else any of the same view. Both null if no background is loaded.
struct ShownBackground {
    const BackgroundCamera* camera = nullptr;
    std::shared_ptr<const render::Background> background;
};

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

// The rig's camera for a picture of this aspect ratio.
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

// Extracts the camera, and the views that it may cut to, without moving it.
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

void show_camera(ecs::Registry& registry, FrameContext& context) {
    move_camera(registry, context);
    extract_camera(registry, context);
}

void pass_time_of_day(ecs::Registry& registry, FrameContext& context) {
    registry.each<TimeOfDay>([&](ecs::Entity, TimeOfDay& time) {
        constexpr double kRatePerS = 3.0;
        time.now = settled(time.now, time.evening, kRatePerS, context.dt_s);
        // Within one 8-bit step of the goal the level is set exactly, so that no further layers are drawn.
        const bool is_there =
            std::abs(time.now.value - time.evening) < 2e-3 && std::abs(time.now.speed) < 1e-2;
        if (is_there || context.dt_s == 0.0) time.now = {.value = time.evening, .speed = 0.0};
        context.scene.levels = light_levels(time.now.value);
    });
}

void show_light(ecs::Registry& registry, FrameContext& context) {
    pass_time_of_day(registry, context);
    registry.each<KeyLight>([&](ecs::Entity, const KeyLight& key) { context.scene.key = key.light; });
    registry.each<Surroundings>([&](ecs::Entity, const Surroundings& surroundings) {
        context.scene.environment = surroundings.environment;
        context.scene.irradiance = surroundings.irradiance;
        context.scene.backdrop = surroundings.backdrop;
    });
}

void show_still_life(ecs::Registry& registry, FrameContext& context) {
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

// Finds the pot on the wheel: another pot that stands there, or the loop's clay, alone or with another pot
// over it.
void find_pot(ecs::Registry& registry, FrameContext& context) {
    const haptic::Snapshot& snapshot = *context.snapshot;
    SeenPot& seen = context.seen;
    seen = {.pot = snapshot.pot, .direction = snapshot.wheel_direction};
    registry.each<PotApart, HeldOver>([&](ecs::Entity, const PotApart& apart, const HeldOver& over) {
        context.stacked = pot::stacked(*snapshot.pot, *apart.pot, over.shift_mm);
        seen.pot = &context.stacked;
        seen.is_apart = true;
    });
    registry.each<PotApart, OnWheel>([&](ecs::Entity, const PotApart& apart, const OnWheel& on_wheel) {
        seen = {.pot = apart.pot,
                .material = apart.material,
                .marks = apart.marks,
                .direction = on_wheel.direction.value_or(snapshot.wheel_direction),
                .is_apart = true};
    });
}

// Converts the pot on the wheel to the lathe that is drawn.
void show_pot(ecs::Registry& registry, FrameContext& context) {
    find_pot(registry, context);
    SeenPot& seen = context.seen;
    const pot::Pot& pot = *seen.pot;
    const bool is_wet = pot.stage == clay::Firing::kWet;
    context.scene.lathe.reset();
    registry.each<Clay>([&](ecs::Entity, Clay& clay) {
        const render::LatheMaterial material =
            seen.material != nullptr ? *seen.material : clay_material(pot.body, pot.stage);
        // Dry clay contains no water, whatever its liquidity was when it was thrown.
        clay.wetness.resize(is_wet ? pot.liquidity.size() : 0);
        std::transform(pot.liquidity.begin(), pot.liquidity.begin() + std::ssize(clay.wetness),
                       pot.film.begin(), clay.wetness.begin(), darkness_of);
        seen.wetness = clay.wetness.empty() ? material.wetness : clay.wetness.back();
        seen.smear = material.albedo * (1.0F - 0.4F * seen.wetness);
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
            .turn = vec2(seen.direction),
            .material = material,
            .shows_load = clay.shows_load,
            .marks = seen.marks};
        if (is_wet) {
            clay.film.resize(pot.film.size());
            std::transform(pot.film.begin(), pot.film.end(), clay.film.begin(), gloss_of);
            lathe.film = clay.film;
        }
        if (clay.is_cut_open) {
            const vec3& eye = context.scene.camera.eye_mm;
            lathe.cut = render::LatheCut{.towards_rad = std::atan2(eye.x, eye.z),
                                         .section = section_colour(lathe.material)};
        }
        context.scene.lathe = lathe;
    });
}

void add_prop(FrameContext& context, ToolModel model, bool left, const mat4& place) {
    context.scene.props.push_back({.model = library_place(model, left),
                                   .place = place,
                                   .smear = context.seen.smear,
                                   .wetness = context.seen.wetness});
}

// What lies on the wheel head turns with it; direction as in SeenPot.
mat4 turned(const dvec2& direction) {
    const vec2 turn(direction);
    return {vec4(turn.x, 0.0F, -turn.y, 0.0F), vec4(0.0F, 1.0F, 0.0F, 0.0F), vec4(turn.y, 0.0F, turn.x, 0.0F),
            vec4(0.0F, 0.0F, 0.0F, 1.0F)};
}

// The height of the wire while it is visible.
std::optional<double> wire_mm(const Wire& wire, const FrameContext& context) {
    if (context.seen.is_apart) return std::nullopt;
    if (wire.held_mm) return wire.held_mm;
    const tool::ToolState& told = context.snapshot->tool;
    return told.wire != tool::Wire::kNone ? std::optional(told.wire_height_mm) : std::nullopt;
}

// Adds the hands with their tools, or the ball of the paper's clay, and the shadows of both.
void show_hands(ecs::Registry& registry, FrameContext& context) {
    render::Scene& scene = context.scene;
    scene.spheres.clear();
    scene.props.clear();
    bool hold_wire = false;
    registry.each<Wire>([&](ecs::Entity, const Wire& wire) {
        hold_wire = wire.held_mm.has_value() && !context.seen.is_apart;
    });
    // The paper's clay is shown with the paper's ball; the studio's clay, whose rings have tops, with hands.
    bool as_ball = true;
    registry.each<ToolShelf>([&](ecs::Entity, const ToolShelf& shelf) {
        scene.prop_library = shelf.library;
        as_ball = !shelf.has_tools() || context.seen.pot->top_mm.empty();
    });
    context.hands = hands_of(*context.snapshot);
    registry.each<Hand>([&](ecs::Entity entity, Hand& hand) {
        const Led* led = registry.find<Led>(entity);
        DrawnHand drawn = led != nullptr ? led->hand : context.hands[hand.is_second ? 1 : 0];
        drawn.shown = drawn.shown && !hand.is_away && !hold_wire;
        drawn.tilt_rad = hand.tilt_rad;
        meet(drawn, *context.seen.pot);
        hand.pose.follow(drawn, context.dt_s);
        if (as_ball) {
            if (!drawn.shown) return;
            const vec3 centre_mm(drawn.position_mm);
            const auto radius_mm = static_cast<float>(drawn.radius_mm);
            add_prop(context, ToolModel::kBall, false,
                     glm::scale(glm::translate(mat4(1.0F), centre_mm), vec3(radius_mm / kBallRadiusMm)));
            scene.spheres.push_back({.centre_mm = centre_mm, .radius_mm = radius_mm});
            return;
        }
        const ToolPicture picture = hand.pose.picture();
        const double scale = render::pixels_per_mm(scene.camera, context.height_px);
        for (const ShownTool& shown : picture.tools)
            add_prop(context, model_at_scale(shown.model, scale), shown.left, shown.place);
        scene.spheres.insert(scene.spheres.end(), picture.shadows.begin(), picture.shadows.end());
    });
}

// Adds the slip on the wheel head, and the drops that fly off wet hands at work.
void show_slip(ecs::Registry& registry, FrameContext& context, bool moves_less) {
    const SeenPot& seen = context.seen;
    // Only thrown clay leaves slip: a pot apart is dry, or held over the clay.
    const bool is_thrown = !seen.is_apart && seen.pot->stage == clay::Firing::kWet;
    const auto add_slip = [&](ToolModel model, const mat4& place) {
        constexpr float kWetter = 0.72F;  // slip is darker than the clay that it comes from
        add_prop(context, model, false, place);
        context.scene.props.back().smear *= kWetter;
        context.scene.props.back().wetness = 1.0F;
    };
    if (is_thrown) add_slip(ToolModel::kSlip, turned(seen.direction));
    const haptic::Snapshot& snapshot = *context.snapshot;
    const bool touches = is_thrown && snapshot.result.forces.contacts > 0;
    registry.each<Splashed>([&](ecs::Entity, Splashed& splashed) {
        splashed.splash.follow({.film = touches ? snapshot.hand_film : 0.0,
                                .from_mm = context.hands[0].position_mm,
                                .wheel_speed_rad_s = snapshot.wheel_speed_rad_s},
                               context.dt_s, moves_less);
        for (const mat4& place : splashed.splash.places())
            add_slip(ToolModel::kDrop, place);
    });
}

// Adds the tools on the bench, slip, shavings and the wire.
void show_tools(ecs::Registry& registry, FrameContext& context) {
    bool moves_less = false;
    registry.each<PhotographedRoom>(
        [&](ecs::Entity, const PhotographedRoom& room) { moves_less = moves_less || room.moves_less; });
    registry.each<Shaved>([&](ecs::Entity, Shaved& shaved) {
        shaved.shavings.follow({.shaved_mm3 = shaved.shaved_mm3,
                                .from_mm = shaved.from_mm,
                                .wheel_speed_rad_s = context.snapshot->wheel_speed_rad_s},
                               context.dt_s, moves_less);
    });
    bool has_tools = false;
    registry.each<ToolShelf>([&](ecs::Entity, const ToolShelf& shelf) { has_tools = shelf.has_tools(); });
    if (!has_tools) return;
    show_slip(registry, context, moves_less);
    registry.each<BenchTool, Transform>([&](ecs::Entity, const BenchTool& tool, const Transform& transform) {
        if (tool.is_photographed || !tool.lies_there) return;
        add_prop(context, tool.model, false, placed(transform.position_mm, tool.yaw_rad, tool.lean_rad));
    });
    registry.each<Shaved>([&](ecs::Entity, const Shaved& shaved) {
        for (const mat4& place : shaved.shavings.places())
            add_prop(context, ToolModel::kCurl, false, place);
    });
    registry.each<Wire>([&](ecs::Entity, const Wire& wire) {
        // Across the picture, so that the wire visibly passes under the pot.
        constexpr double kAcross = 0.5 * kPi;
        if (const auto height_mm = wire_mm(wire, context))
            add_prop(context, ToolModel::kWire, false, placed({0.0, *height_mm, 0.0}, kAcross, 0.0));
    });
}

// The order matters: a cut faces the camera, and the pot's clay sticks to the hands.
using System = void (*)(ecs::Registry&, FrameContext&);
constexpr std::array<System, 6> kSystems{show_camera, show_light, show_still_life,
                                         show_pot,    show_hands, show_tools};

// The tools on the bench lie as in assets/workshop/maker/tools.py. The rib, for which the photographs have a
// gap, leans against the cup.
struct LyingTool {
    BenchTool tool;
    dvec3 at_mm;
};
constexpr std::array kLying{
    LyingTool{{.tool = tool::Tool::kSponge, .model = ToolModel::kSponge, .target_u = {112.0F, 94.0F}},
              {300.0, -45.0, 45.0}},
    LyingTool{{.tool = tool::Tool::kWire, .model = ToolModel::kWire, .target_u = {250.0F, 78.0F}},
              {-325.0, -50.0, -128.0}},
    LyingTool{{.tool = tool::Tool::kRib,
               .model = ToolModel::kRib,
               .target_u = {80.0F, 130.0F},
               .is_photographed = false,
               .lies_there = false,
               .yaw_rad = -0.35,
               .lean_rad = 0.28},
              {268.0, -22.0, -58.0}}};

}  // namespace

WheelScene::WheelScene(std::shared_ptr<const Workshop> workshop, RoomModel model) {
    const auto make = [&](auto component) {
        const ecs::Entity entity = registry_.create();
        registry_.add(entity, std::move(component));
        return entity;
    };
    clay_ = make(Clay{.edge_rounding_mm = 4.0F});
    hands_ = {make(Hand{}), make(Hand{.is_second = true})};
    wire_ = make(Wire{});
    shavings_ = make(Shaved{});
    make(Splashed{});
    for (const LyingTool& lying : kLying)
        registry_.add(make(lying.tool), Transform{lying.at_mm});
    shelf_ = make(ToolShelf{ball_alone()});
    const ecs::Entity camera = make(throwing_camera());
    make(TimeOfDay{});
    if (workshop) {
        if (model.parts.empty()) {
            stand_in(registry_, *workshop);
        } else {
            build_room(registry_, *workshop, std::move(model));
        }
        registry_.add(camera, PhotographedRoom{.workshop = std::move(workshop)});
    } else {
        furnish(registry_);
    }
}

std::vector<const BackgroundCamera*> WheelScene::missing_backgrounds(int width_px, int height_px) {
    std::vector<const BackgroundCamera*> missing;
    registry_.each<PhotographedRoom>([&](ecs::Entity, const PhotographedRoom& room) {
        for (const View view : {View::kThrowing, View::kLookingIn}) {
            const BackgroundCamera* camera = room.workshop->camera_for(view, width_px, height_px);
            if (camera != nullptr && !room.backgrounds.contains(camera->name)) missing.push_back(camera);
        }
    });
    return missing;
}

void WheelScene::add_background(const std::string& camera_name,
                                std::shared_ptr<const render::Background> background) {
    registry_.each<PhotographedRoom>(
        [&](ecs::Entity, PhotographedRoom& room) { room.backgrounds[camera_name] = std::move(background); });
}

void WheelScene::drop_backgrounds_of_other_shapes(int width_px, int height_px) {
    registry_.each<PhotographedRoom>([&](ecs::Entity, PhotographedRoom& room) {
        std::map<std::string, std::shared_ptr<const render::Background>> kept;
        for (const View view : {View::kThrowing, View::kLookingIn}) {
            const BackgroundCamera* camera = room.workshop->camera_for(view, width_px, height_px);
            const auto found =
                camera == nullptr ? room.backgrounds.end() : room.backgrounds.find(camera->name);
            if (found != room.backgrounds.end()) kept.insert(*found);
        }
        if (!kept.empty()) room.backgrounds = std::move(kept);
    });
}

bool WheelScene::has_backgrounds() {
    bool has = false;
    registry_.each<PhotographedRoom>(
        [&](ecs::Entity, const PhotographedRoom& room) { has = has || !room.backgrounds.empty(); });
    return has;
}

std::shared_ptr<const Workshop> WheelScene::workshop() {
    std::shared_ptr<const Workshop> found;
    registry_.each<PhotographedRoom>(
        [&](ecs::Entity, const PhotographedRoom& room) { found = room.workshop; });
    return found;
}

void WheelScene::look_at(View view) {
    registry_.each<PhotographedRoom>([&](ecs::Entity, PhotographedRoom& room) { room.view = view; });
}

void WheelScene::set_framing(const Framing& framing) {
    registry_.each<PhotographedRoom>([&](ecs::Entity, PhotographedRoom& room) { room.framing = framing; });
}

void WheelScene::next_view_is_ready() {
    registry_.each<PhotographedRoom>([&](ecs::Entity, PhotographedRoom& room) { room.next_is_ready = true; });
}

void WheelScene::move_less(bool less) {
    registry_.each<PhotographedRoom>([&](ecs::Entity, PhotographedRoom& room) { room.moves_less = less; });
}

void WheelScene::jump() {
    registry_.each<PhotographedRoom>([&](ecs::Entity, PhotographedRoom& room) { room.jumps = true; });
}

void WheelScene::sway(bool sways) {
    registry_.each<PhotographedRoom>([&](ecs::Entity, PhotographedRoom& room) { room.sways = sways; });
}

void WheelScene::set_evening(double evening) {
    registry_.each<TimeOfDay>([&](ecs::Entity, TimeOfDay& time) { time.evening = evening; });
}

const render::Scene& WheelScene::apply(const haptic::Snapshot& snapshot, int width_px, int height_px,
                                       double dt_s) {
    context_.snapshot = &snapshot;
    context_.width_px = width_px;
    context_.height_px = height_px;
    context_.dt_s = dt_s;
    for (const System system : kSystems)
        system(registry_, context_);
    context_.snapshot = nullptr;
    return context_.scene;
}

void WheelScene::show_hands(bool shown) {
    registry_.each<Hand>([&](ecs::Entity, Hand& hand) { hand.is_away = !shown; });
}

void WheelScene::tilt_hand(const dvec2& tilt_rad) {
    registry_.find<Hand>(hands_[0])->tilt_rad = tilt_rad;
}

void WheelScene::lead_hands(const std::optional<std::array<DrawnHand, 2>>& hands) {
    for (std::size_t i = 0; i < hands_.size(); ++i) {
        if (hands) {
            registry_.add(hands_[i], Led{(*hands)[i]});
        } else {
            registry_.remove<Led>(hands_[i]);
        }
    }
}

void WheelScene::hold_wire(const std::optional<double>& height_mm) {
    registry_.get<Wire>(wire_).held_mm = height_mm;
}

void WheelScene::shave(double shaved_mm3, const dvec3& from_mm) {
    Shaved& shaved = registry_.get<Shaved>(shavings_);
    shaved.shaved_mm3 = shaved_mm3;
    shaved.from_mm = from_mm;
}

void WheelScene::lay_on_bench(tool::Tool tool, bool lies_there) {
    registry_.each<BenchTool>([&](ecs::Entity, BenchTool& on_bench) {
        if (on_bench.tool == tool) on_bench.lies_there = lies_there;
    });
}

void WheelScene::put_on_wheel(ecs::Entity& entity, const PotApart& pot, const OnWheel& on_wheel) {
    if (!registry_.alive(entity)) entity = registry_.create();
    registry_.add(entity, pot);
    registry_.add(entity, on_wheel);
}

void WheelScene::set_tools(std::shared_ptr<const render::PropLibrary> library) {
    registry_.get<ToolShelf>(shelf_).library = std::move(library);
}

void WheelScene::forget_hands() {
    registry_.each<Hand>([](ecs::Entity, Hand& hand) { hand.pose = {}; });
}

bool WheelScene::has_tools() {
    return registry_.get<ToolShelf>(shelf_).has_tools();
}

const render::Camera& WheelScene::camera_now(int width_px, int height_px) {
    context_.width_px = width_px;
    context_.height_px = height_px;
    extract_camera(registry_, context_);
    return context_.scene.camera;
}

std::optional<dvec2> WheelScene::project_framed(View view, const Framing& framing, int width_px,
                                                int height_px, const dvec3& place_mm) {
    std::optional<dvec2> pixel;
    registry_.each<PhotographedRoom>([&](ecs::Entity, const PhotographedRoom& room) {
        const BackgroundCamera* taken = room.workshop->camera_for(view, width_px, height_px);
        if (taken == nullptr) return;
        const render::Camera camera = framed(
            render::background_camera(taken->camera, taken->width_px, taken->height_px, width_px, height_px),
            framing);
        if (const auto seen = render::project(camera, width_px, height_px, place_mm)) pixel = seen->pixel;
    });
    return pixel;
}

std::optional<dvec3> WheelScene::tool_target_mm(double x_px, double y_px, int width_px, int height_px) {
    const render::Camera& camera = camera_now(width_px, height_px);
    return render::meet_axis_plane(render::ray_through(camera, width_px, height_px, {x_px, y_px}), camera);
}

namespace {

bool is_model(const std::filesystem::path& room) {
    return room.extension() == ".glb";
}

// `note` receives the parts of the room's model that are not drawn.
Result<std::unique_ptr<WheelScene>> furnished(const std::filesystem::path& room, int width_px, int height_px,
                                              std::string& note) {
    const auto with_model = [&](const std::shared_ptr<const Workshop>& workshop,
                                const std::filesystem::path& file) -> Result<std::unique_ptr<WheelScene>> {
        auto model = load_room_model(file);
        if (!model) return model.error();
        note = fmt::format("{}", fmt::join(model->left_out, ", "));
        return std::make_unique<WheelScene>(workshop, std::move(*model));
    };
    std::filesystem::path folder = room;
    if (room.empty() || is_model(room)) {  // a model has no light and cameras: use the workshop's
        auto found = files::find_asset("workshop");
        if (!found) return found.error();
        folder = std::move(*found);
    }
    auto workshop = load_workshop(folder);
    if (!workshop) return workshop.error();
    auto shared = std::make_shared<const Workshop>(std::move(*workshop));
    auto scene = std::make_unique<WheelScene>(shared);
    if (is_model(room)) return with_model(shared, room);
    // The room has a model, but no photographs yet.
    std::error_code error;
    const bool has_backgrounds = std::filesystem::exists(folder / "plates", error);
    if (!has_backgrounds && std::filesystem::exists(folder / "room.glb", error))
        return with_model(shared, folder / "room.glb");
    for (const BackgroundCamera* camera : scene->missing_backgrounds(width_px, height_px)) {
        auto background = load_background(*shared, *camera);
        if (!background) return background.error();
        scene->add_background(camera->name, std::move(*background));
    }
    return scene;
}

}  // namespace

OpenedScene open_scene(const std::filesystem::path& folder, int width_px, int height_px) {
    OpenedScene opened;
    auto scene = furnished(folder, width_px, height_px, opened.note);
    if (!scene && !folder.empty()) {
        opened.lack = scene.error().message + "; the program's own room is shown";
        scene = furnished({}, width_px, height_px, opened.note);
    }
    if (!scene && opened.lack.empty()) opened.lack = scene.error().message;
    opened.scene = scene ? std::move(*scene) : std::make_unique<WheelScene>();
    if (auto tools = load_tool_models()) {
        opened.scene->set_tools(std::move(*tools));
    } else if (opened.lack.empty()) {
        opened.lack = tools.error().message;
    }
    return opened;
}

}  // namespace onggi::wheel

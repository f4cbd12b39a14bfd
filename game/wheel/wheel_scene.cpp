#include "game/wheel/wheel_scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <utility>

#include "engine/files/asset_folder.h"
#include "game/wheel/components.h"
#include "game/wheel/tool_models.h"
#include "game/wheel/workshop.h"

namespace onggi::wheel {
namespace {

bool is_model(const std::filesystem::path& room) {
    return room.extension() == ".glb";
}

// `note`: what of the room's model is not drawn.
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
    if (room.empty() || is_model(room)) {  // a model has no light and cameras: use ours
        auto found = files::find_asset("workshop");
        if (!found) return found.error();
        folder = std::move(*found);
    }
    auto workshop = load_workshop(folder);
    if (!workshop) return workshop.error();
    auto shared = std::make_shared<const Workshop>(std::move(*workshop));
    auto scene = std::make_unique<WheelScene>(shared);
    if (is_model(room)) return with_model(shared, room);
    // A room that has a model but no photographs yet.
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

WheelScene::WheelScene(std::shared_ptr<const Workshop> workshop, RoomModel model) {
    clay_ = registry_.create();
    registry_.add(clay_, Clay{.edge_rounding_mm = 4.0F});
    registry_.add(clay_, Wheel{});
    tool_ = registry_.create();
    registry_.add(tool_, Tool{});
    second_tool_ = registry_.create();
    registry_.add(second_tool_, Tool{.sight = {.shown = false, .is_assistant = true}});
    registry_.add(registry_.create(), Wire{});
    registry_.add(registry_.create(), Shaved{});
    registry_.add(registry_.create(), OnBench{});
    shelf_ = registry_.create();
    registry_.add(shelf_, ToolShelf{ball_alone()});
    camera_ = registry_.create();
    registry_.add(camera_, throwing_camera());
    registry_.add(registry_.create(), TimeOfDay{});
    if (workshop) {
        if (model.parts.empty()) {
            stand_in(registry_, *workshop);
        } else {
            build_room(registry_, *workshop, std::move(model));
        }
        registry_.add(camera_, PhotographedRoom{.workshop = std::move(workshop)});
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

const render::Scene& WheelScene::apply(const WheelView& shown, int width_px, int height_px, double dt_s) {
    context_.shown = &shown;
    context_.width_px = width_px;
    context_.height_px = height_px;
    context_.dt_s = dt_s;
    schedule_.run(registry_, context_);
    context_.shown = nullptr;
    return context_.scene;
}

void WheelScene::set_tools(std::shared_ptr<const render::PropLibrary> library) {
    registry_.get<ToolShelf>(shelf_).library = std::move(library);
}

void WheelScene::forget_hands() {
    registry_.each<Tool>([](ecs::Entity, Tool& tool) { tool.pose = {}; });
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

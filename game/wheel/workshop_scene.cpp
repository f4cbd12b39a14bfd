#include "game/wheel/workshop_scene.h"

#include <utility>

#include "engine/files/asset_folder.h"
#include "game/wheel/tool_models.h"

namespace onggi::wheel {
namespace {

bool is_model(const std::filesystem::path& room) {
    return room.extension() == ".glb";
}

Result<std::unique_ptr<WheelScene>> furnished(const std::filesystem::path& room, int width_px,
                                              int height_px) {
    std::filesystem::path folder = room;
    if (room.empty() || is_model(room)) {  // a model comes without light and cameras: ours
        auto found = files::find_asset("workshop");
        if (!found) return found.error();
        folder = std::move(*found);
    }
    auto workshop = load_workshop(folder);
    if (!workshop) return workshop.error();
    auto shared = std::make_shared<const Workshop>(std::move(*workshop));
    auto scene = std::make_unique<WheelScene>(shared);
    if (is_model(room)) {
        auto model = load_room_model(room);
        if (!model) return model.error();
        return std::make_unique<WheelScene>(shared, std::move(*model));
    }
    // A room that has been modelled and not photographed yet.
    std::error_code error;
    const bool has_backgrounds = std::filesystem::exists(folder / "plates", error);
    if (!has_backgrounds && std::filesystem::exists(folder / "room.glb", error)) {
        auto model = load_room_model(folder / "room.glb");
        if (!model) return model.error();
        return std::make_unique<WheelScene>(shared, std::move(*model));
    }
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
    auto scene = furnished(folder, width_px, height_px);
    if (!scene && !folder.empty()) {
        opened.lack = scene.error().message + "; the program's own room is shown";
        scene = furnished({}, width_px, height_px);
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

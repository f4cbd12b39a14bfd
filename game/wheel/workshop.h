// The still life around the wheel, its materials and its light. Main thread.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/ecs/registry.h"
#include "engine/render/scene.h"
#include "game/wheel/components.h"

namespace onggi::wheel {

// Adds the still parts, the key light and the surroundings as entities: a small still life that needs no
// file.
void furnish(ecs::Registry& registry);

// Adds a photographed workshop: its light, and the surfaces that catch a pot's shadow. The surfaces are not
// drawn: the backgrounds are projected on them.
void stand_in(ecs::Registry& registry, const Workshop& workshop);

// A room as a glTF model, used while it has no backgrounds: a museum's own room before they are rendered. mm.
struct RoomModel {
    std::vector<StillPart> parts = {};
    bool has_wheel = false;  // a node or mesh is named "wheel"; otherwise the scene adds its own wheel
    std::vector<std::string> left_out = {};  // parts of the file that are not drawn
};

// Metres, +Y up, the origin in the middle of the wheel head's top, as assets/workshop/README.md specifies.
// Drawn in the materials' plain colours. Bad input: not a GLB, or a room that is not 1 to 100 m large.
// Any thread but the haptic one; blocks.
[[nodiscard]] Result<RoomModel> load_room_model(const std::filesystem::path& file);

// Adds a modelled room in the workshop's light, with the scene's own wheel if the model has none.
void build_room(ecs::Registry& registry, const Workshop& workshop, RoomModel model);

[[nodiscard]] CameraRig throwing_camera();

}  // namespace onggi::wheel

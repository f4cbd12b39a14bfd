// A room as a glTF model, used while it has no backgrounds: a museum's own room before they are rendered. Any
// thread but the haptic one; blocks. mm.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "game/wheel/components.h"

namespace onggi::wheel {

struct RoomModel {
    std::vector<StillPart> parts = {};
    bool has_wheel = false;  // a node or mesh is named "wheel"; otherwise the scene adds its own wheel
    std::vector<std::string> left_out = {};  // what of the file is not drawn
};

// Metres, +Y up, the origin in the middle of the wheel head's top, as assets/workshop/README.md specifies.
// Drawn in the materials' plain colours. Bad input: not a GLB, or a room that is not 1 to 100 m large.
[[nodiscard]] Result<RoomModel> load_room_model(const std::filesystem::path& file);

}  // namespace onggi::wheel

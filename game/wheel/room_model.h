// A room as a glTF model, for where no backgrounds of it were taken: a museum's own, before its backgrounds
// are made. Any thread but the haptic one; blocks. mm.
#pragma once

#include <filesystem>
#include <vector>

#include "engine/core/result.h"
#include "game/wheel/components.h"

namespace onggi::wheel {

struct RoomModel {
    std::vector<StillPart> parts;
    bool has_wheel = false;  // a node's name begins with "wheel"; without one the scene puts its own there
};

// Metres, +Y up, the origin in the middle of the wheel head's top, as assets/workshop/README.md asks. Drawn
// in the materials' plain colours. Bad input: no GLB, or a room that is not 1 to 100 m large.
[[nodiscard]] Result<RoomModel> load_room_model(const std::filesystem::path& file);

}  // namespace onggi::wheel

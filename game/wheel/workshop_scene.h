// A wheel scene with the workshop and the tools that the program brings, ready for its first picture. Main
// thread; blocks while it reads.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "game/wheel/wheel_scene.h"

namespace onggi::wheel {

struct OpenedScene {
    std::unique_ptr<WheelScene> scene;  // never null
    std::string lack;  // why it shows another room, or balls for tools, instead; empty: it does not
};

// `folder`: of a photographed room, or of one that has only been modelled (room.glb), or a GLB file itself,
// which is then seen in the light and from the cameras of ours; empty: the one that comes with the program.
// Whatever is wrong with it, a pot can still be thrown: the scene then shows the program's own room, or where
// that is what is wrong, the small still life, and says why.
[[nodiscard]] OpenedScene open_scene(const std::filesystem::path& folder, int width_px, int height_px);

}  // namespace onggi::wheel

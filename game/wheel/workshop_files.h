// The photographed workshop on disk: cameras.json, light.json, plates/NAME_key.jpg and
// plates/NAME_ambient.jpg (assets/workshop/README.md describes them). Any thread but the haptic one; blocks.
// mm, rad, linear light.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/scene.h"

namespace onggi::wheel {

// The views of a visitor. Camera names begin with the view's name.
enum class View {
    kThrowing,   // throw_...: pot and hands
    kLookingIn,  // look_in_...: from above, into the pot
};
[[nodiscard]] std::string_view name_of(View view);

// A fixed camera, and the size of its backgrounds.
struct BackgroundCamera {
    std::string name;
    render::Camera camera;
    int width_px = 0;
    int height_px = 0;
};

// The light on a pot in this room, without the backgrounds themselves.
struct Workshop {
    std::filesystem::path folder;
    std::vector<BackgroundCamera> cameras;  // larger variants are listed only if their photographs exist
    render::DirectionalLight key;
    std::array<vec3, 9> irradiance{};  // see render::sky_irradiance()
    render::Environment environment;

    // The camera of this view with the nearest aspect ratio, and among equals with the nearest size; null if
    // the view has no camera.
    [[nodiscard]] const BackgroundCamera* camera_for(View view, int width_px, int height_px) const;
};

// Reads both JSON files. Bad input: a file that is missing, too large or not JSON, or a field that is missing
// or out of range; the message names file and field. The result has at least one throwing camera.
[[nodiscard]] Result<Workshop> load_workshop(const std::filesystem::path& folder);

// The backgrounds of one camera. Bad input: a file that is missing or damaged, or differs in size from
// cameras.json.
[[nodiscard]] Result<std::shared_ptr<const render::Background>> load_background(
    const Workshop& workshop, const BackgroundCamera& camera);

}  // namespace onggi::wheel

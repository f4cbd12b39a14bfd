// The photographed workshop as it lies on the disk: cameras.json, light.json, plates/NAME_key.jpg and
// plates/NAME_ambient.jpg (assets/workshop/README.md says what they mean). Any thread but the haptic
// one; blocks. mm, rad, linear light.
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

// What a visitor looks at. The name of a camera begins with the view's own.
enum class View {
    kThrowing,   // throw_...: pot and hands
    kLookingIn,  // look_in_...: from above, into the pot
};
[[nodiscard]] std::string_view name_of(View view);

// A fixed camera, and the size of the backgrounds it took.
struct BackgroundCamera {
    std::string name;
    render::Camera camera;
    int width_px = 0;
    int height_px = 0;
};

// The light that reaches a pot in this room, without the backgrounds themselves.
struct Workshop {
    std::filesystem::path folder;
    std::vector<BackgroundCamera> cameras;  // those that are larger than another only with their photographs
    render::DirectionalLight key;
    std::array<vec3, 9> irradiance{};  // see render::sky_irradiance()
    render::Environment environment;

    // The camera of this view whose shape is nearest to the picture's, and of those the one whose size is;
    // null if the view has none.
    [[nodiscard]] const BackgroundCamera* camera_for(View view, int width_px, int height_px) const;
};

// Reads both JSON files. Bad input: a file that is missing, too large or no JSON, or a field that is missing
// or out of range; the message names file and field. There is a throwing camera at the least.
[[nodiscard]] Result<Workshop> load_workshop(const std::filesystem::path& folder);

// The backgrounds of one camera. Bad input: a file that is missing or damaged, or has another size than
// cameras.json says.
[[nodiscard]] Result<std::shared_ptr<const render::Background>> load_background(
    const Workshop& workshop, const BackgroundCamera& camera);

}  // namespace onggi::wheel

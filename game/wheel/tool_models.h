// The hands and tools of assets/tools as models to draw, and the paper's ball. Main thread; read once, while
// loading.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>

#include "engine/core/result.h"
#include "engine/render/prop.h"

namespace onggi::wheel {

// Indices in the library. Every model touches the clay at its origin, with the clay on its -X side and +Y up;
// those of a right hand extend to the visitor's right, at +Z. The mirrored ones are left hands.
enum class ToolModel : std::size_t {
    kBall,  // wooden, radius kBallRadiusMm about its origin
    kHandOuter,
    kHandInner,
    kRib,
    kSponge,
    kTrimmer,
    kStick,
    kWire,
    kCurl,          // a shaving, about its origin, its axis along X
    kDrop,          // of slip, about its origin
    kSlip,          // streaks and drops of slip on the wheel head, about the wheel's axis
    kFarHandOuter,  // the hands with fewer triangles
    kFarHandInner,
    kCount,
};
constexpr std::size_t kToolModels = static_cast<std::size_t>(ToolModel::kCount);
// The GLB files of the models between kBall and kCurl; the others are built here.
constexpr std::array<const char*, kToolModels - 6> kToolFiles{"hand_outer", "hand_inner", "rib", "sponge",
                                                              "trimmer",    "stick",      "wire"};
constexpr float kBallRadiusMm = 10.0F;

// Index of a model, or of its mirror image in z for a left hand.
[[nodiscard]] constexpr std::size_t library_place(ToolModel model, bool left) {
    return static_cast<std::size_t>(model) + (left ? kToolModels : 0);
}

// The model that shows a hand in a picture of this scale, in pixels per mm at the wheel: one with fewer
// triangles where most of them would be under two pixels; `model` itself for anything else.
[[nodiscard]] ToolModel model_at_scale(ToolModel model, double pixels_per_mm);

// A library with only the ball, which needs no file.
[[nodiscard]] std::shared_ptr<const render::PropLibrary> ball_alone();

// The ball and the folder's GLB files. Passes on read and format errors.
Result<std::shared_ptr<const render::PropLibrary>> load_tool_models(const std::filesystem::path& folder);

// The models of the installed folder; system lacks if there is no such folder.
Result<std::shared_ptr<const render::PropLibrary>> load_tool_models();

}  // namespace onggi::wheel

// The hands and tools of assets/tools as models that can be drawn, and the paper's ball. Main thread; read
// once, while loading.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>

#include "engine/core/result.h"
#include "engine/render/prop.h"

namespace onggi::wheel {

// Places in the library. Every model touches the clay at its origin, clay on its -X side, up is +Y; those of
// a right hand lead to the visitor's right, at +Z. The mirrored ones are left hands.
enum class ToolModel : std::size_t {
    kBall,  // of wood, kBallRadiusMm about its origin
    kHandOuter,
    kHandInner,
    kRib,
    kSponge,
    kTrimmer,
    kStick,
    kWire,
    kCurl,  // a shaving, about its origin, its axis along X
    kCount,
};
constexpr std::size_t kToolModels = static_cast<std::size_t>(ToolModel::kCount);
constexpr float kBallRadiusMm = 10.0F;

// Where the rib lies on the bench of assets/workshop, which has room for it.
constexpr dvec3 kRibOnBenchMm{268.0, -22.0, -58.0};

// The place of a model, or of its mirror image in z, which a left hand leads.
[[nodiscard]] constexpr std::size_t library_place(ToolModel model, bool left) {
    return static_cast<std::size_t>(model) + (left ? kToolModels : 0);
}

// A library of the ball alone, which needs no file.
[[nodiscard]] std::shared_ptr<const render::PropLibrary> ball_alone();

// The ball, and the folder's GLB files. What a read or a file's contents have against it comes back as it is.
Result<std::shared_ptr<const render::PropLibrary>> load_tool_models(const std::filesystem::path& folder);

// Those of the folder that the program brings; system lacks where there is none.
Result<std::shared_ptr<const render::PropLibrary>> load_tool_models();

}  // namespace onggi::wheel

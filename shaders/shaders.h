// The shaders as SPIR-V inside the program, which needs no files beside it. Any thread; constant.
#pragma once

#include <cstdint>
#include <span>

namespace onggi::shaders {

using Spirv = std::span<const std::uint32_t>;

// A shader's source file and definitions, for recompiling it.
struct Source {
    const char* file = "";         // "mesh.frag"
    const char* definitions = "";  // separated by spaces
    Spirv spirv;
};
[[nodiscard]] std::span<const Source> sources();

extern const Spirv kScreenVert;
extern const Spirv kBackdropFrag;
extern const Spirv kBackdropLayersFrag;
extern const Spirv kMeshVert;
extern const Spirv kMeshFrag;
extern const Spirv kMeshLayersFrag;
extern const Spirv kShadowMapVert;
extern const Spirv kLatheVert;
extern const Spirv kLatheFrag;
extern const Spirv kPropVert;
extern const Spirv kPropFrag;
extern const Spirv kMaskFrag;
extern const Spirv kLatheMarksFrag;
extern const Spirv kLatheLoadVert;
extern const Spirv kLatheLoadFrag;
extern const Spirv kLatheSectionVert;
extern const Spirv kLatheSectionFrag;
extern const Spirv kBackgroundFrag;
extern const Spirv kPlacesFrag;
extern const Spirv kViewFadeFrag;
extern const Spirv kBackgroundSurfaceVert;
extern const Spirv kBackgroundSurfaceFrag;
extern const Spirv kUiVert;
extern const Spirv kUiFrag;
extern const Spirv kUiPictureFrag;

}  // namespace onggi::shaders

// The shaders as SPIR-V inside the program, so that it needs no files beside it. Any thread; constant.
#pragma once

#include <cstdint>
#include <span>

namespace onggi::shaders {

using Spirv = std::span<const std::uint32_t>;

extern const Spirv kScreenVert;
extern const Spirv kBackdropFrag;
extern const Spirv kBackdropLayersFrag;
extern const Spirv kMeshVert;
extern const Spirv kMeshFrag;
extern const Spirv kMeshLayersFrag;
extern const Spirv kKeyMapVert;
extern const Spirv kLatheVert;
extern const Spirv kLatheFrag;
extern const Spirv kMaskFrag;
extern const Spirv kShadeVert;
extern const Spirv kShadeFrag;

}  // namespace onggi::shaders

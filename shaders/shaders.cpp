#include "shaders/shaders.h"

// Written by glslangValidator while building; see CMakeLists.txt.
#include "backdrop_frag.h"
#include "backdrop_layers_frag.h"
#include "key_map_vert.h"
#include "lathe_frag.h"
#include "lathe_vert.h"
#include "mask_frag.h"
#include "mesh_frag.h"
#include "mesh_layers_frag.h"
#include "mesh_vert.h"
#include "screen_vert.h"
#include "shade_frag.h"
#include "shade_vert.h"

namespace onggi::shaders {

const Spirv kScreenVert = screen_vert;
const Spirv kBackdropFrag = backdrop_frag;
const Spirv kBackdropLayersFrag = backdrop_layers_frag;
const Spirv kMeshVert = mesh_vert;
const Spirv kMeshFrag = mesh_frag;
const Spirv kMeshLayersFrag = mesh_layers_frag;
const Spirv kKeyMapVert = key_map_vert;
const Spirv kLatheVert = lathe_vert;
const Spirv kLatheFrag = lathe_frag;
const Spirv kMaskFrag = mask_frag;
const Spirv kShadeVert = shade_vert;
const Spirv kShadeFrag = shade_frag;

}  // namespace onggi::shaders

#include "shaders/shaders.h"

// Written by glslangValidator while building; see CMakeLists.txt.
#include "backdrop_frag.h"
#include "backdrop_layers_frag.h"
#include "background_frag.h"
#include "background_surface_frag.h"
#include "background_surface_vert.h"
#include "lathe_frag.h"
#include "lathe_load_frag.h"
#include "lathe_load_vert.h"
#include "lathe_marks_frag.h"
#include "lathe_section_frag.h"
#include "lathe_section_vert.h"
#include "lathe_vert.h"
#include "mask_frag.h"
#include "mesh_frag.h"
#include "mesh_layers_frag.h"
#include "mesh_vert.h"
#include "places_frag.h"
#include "prop_frag.h"
#include "prop_vert.h"
#include "screen_vert.h"
#include "shadow_map_vert.h"
#include "ui_frag.h"
#include "ui_picture_frag.h"
#include "ui_vert.h"
#include "view_fade_frag.h"

namespace onggi::shaders {

const Spirv kScreenVert = screen_vert;
const Spirv kBackdropFrag = backdrop_frag;
const Spirv kBackdropLayersFrag = backdrop_layers_frag;
const Spirv kMeshVert = mesh_vert;
const Spirv kMeshFrag = mesh_frag;
const Spirv kMeshLayersFrag = mesh_layers_frag;
const Spirv kShadowMapVert = shadow_map_vert;
const Spirv kLatheVert = lathe_vert;
const Spirv kLatheFrag = lathe_frag;
const Spirv kPropVert = prop_vert;
const Spirv kPropFrag = prop_frag;
const Spirv kMaskFrag = mask_frag;
const Spirv kLatheMarksFrag = lathe_marks_frag;
const Spirv kLatheLoadVert = lathe_load_vert;
const Spirv kLatheLoadFrag = lathe_load_frag;
const Spirv kLatheSectionVert = lathe_section_vert;
const Spirv kLatheSectionFrag = lathe_section_frag;
const Spirv kBackgroundFrag = background_frag;
const Spirv kPlacesFrag = places_frag;
const Spirv kViewFadeFrag = view_fade_frag;
const Spirv kBackgroundSurfaceVert = background_surface_vert;
const Spirv kBackgroundSurfaceFrag = background_surface_frag;
const Spirv kUiVert = ui_vert;
const Spirv kUiFrag = ui_frag;
const Spirv kUiPictureFrag = ui_picture_frag;

std::span<const Source> sources() {
    static const Source all[] = {
#include "sources.inc"
    };
    return all;
}

}  // namespace onggi::shaders

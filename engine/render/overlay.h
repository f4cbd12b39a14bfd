// The overlay, drawn over a scene or in its place: a draw list, and the pictures of the atlas that are not on
// the device yet. Main thread; must live until the draw call returns.
#pragma once

#include <span>

#include "engine/ui/atlas.h"
#include "engine/ui/draw_list.h"

namespace onggi::render {

struct Overlay {
    const ui::DrawList* list = nullptr;
    std::span<const ui::Atlas::Upload> uploads{};
    int atlas_side_px = 0;
    // A screen that covers everything is fading in or out over the scene, or is about to. The renderer may
    // freeze the scene meanwhile.
    bool scene_rests = false;
    bool covers = false;  // covers every pixel: the scene is not drawn, and an unchanged list is only copied
};

}  // namespace onggi::render

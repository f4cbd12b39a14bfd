// What is laid over a scene, or stands instead of it: a draw list, and the pictures it needs that the device
// has not got yet. Main thread; must live until the draw call has returned.
#pragma once

#include <span>

#include "engine/ui/atlas.h"
#include "engine/ui/draw_list.h"

namespace onggi::render {

struct Overlay {
    const ui::DrawList* list = nullptr;
    std::span<const ui::Atlas::Upload> uploads{};
    int atlas_side_px = 0;
    // A screen that covers all is fading in or out over the scene, or is about to: the scene may stand still
    // meanwhile.
    bool scene_rests = false;
    bool covers = false;  // every pixel: the scene is not drawn at all, and an unchanged list is only copied
};

}  // namespace onggi::render

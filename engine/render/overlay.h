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
    bool covers = false;  // every pixel: the scene is not drawn at all, and an unchanged list is only copied
};

}  // namespace onggi::render

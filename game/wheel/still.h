// One finished picture of a pot on its wheel, drawn without a window: MSAA x4, exact sRGB, the same bytes
// every time on the same driver. Main thread; makes its own Vulkan device and lets it go again.
#pragma once

#include "engine/asset/image.h"
#include "engine/core/result.h"
#include "game/wheel/pot_view.h"

namespace onggi::wheel {

struct StillOptions {
    bool validation = false;  // with VK_LAYER_KHRONOS_validation; any message is then an error
};

// width and height in pixels, 16 to 8192 each, else bad input. Without a Vulkan device: system lacks.
Result<asset::Image> render_still(const PotView& pot, int width, int height,
                                  const StillOptions& options = {});

}  // namespace onggi::wheel

// One finished picture of a pot on its wheel, drawn without a window: MSAA x4, exact sRGB, the same bytes
// every time on the same driver. Main thread; makes its own Vulkan device and lets it go again.
#pragma once

#include <filesystem>

#include "engine/asset/image.h"
#include "engine/core/result.h"
#include "game/wheel/wheel_view.h"

namespace onggi::wheel {

constexpr int kBeautySamples = 48;

// What a picture shows.
enum class StillView {
    kThrowing,  // pot and hands
    kLookingIn,
    kPortrait,  // the throwing view without hands: the pot as it will be kept
    kCutaway,   // cut open towards the camera, with its section; load shown as a hatch
};

struct StillOptions {
    StillView view = StillView::kThrowing;
    std::filesystem::path workshop = {};  // folder of a photographed room; empty: the program's own
    bool beauty =
        false;  // the mean of kBeautySamples pictures: finer edges, shadows as soft as the light is wide
    // As the live window of a processor shows it, whatever the device: ten times as quick, and coarser:
    // one sample a pixel, with smoothed outlines.
    bool quick = false;
    bool validation = false;  // with VK_LAYER_KHRONOS_validation; any message is then an error
};

// width and height in pixels, 16 to 8192 each, else bad input. Without a Vulkan device: system lacks.
Result<asset::Image> render_still(const WheelView& shown, int width, int height,
                                  const StillOptions& options = {});

}  // namespace onggi::wheel

// One finished picture of a pot on its wheel, drawn without a window: MSAA x4, exact sRGB, the same bytes
// every time on the same driver. Main thread; creates and releases its own Vulkan device.
#pragma once

#include <filesystem>

#include "engine/asset/image.h"
#include "engine/core/result.h"
#include "game/wheel/wheel_view.h"

namespace onggi::wheel {

constexpr int kBeautySamples = 48;

// The content of a picture.
enum class StillView {
    kThrowing,  // pot and hands
    kLookingIn,
    kPortrait,  // the throwing view without hands: the pot to keep
    kCutaway,   // cut open towards the camera, with its section; load shown as a hatch
};

struct StillOptions {
    StillView view = StillView::kThrowing;
    std::filesystem::path workshop = {};  // folder of a photographed room; empty: the installed one
    bool beauty =
        false;  // the mean of kBeautySamples pictures: finer edges, soft shadows from the light's full width
    // Draws as the live window does on a processor, whatever the device: ten times as fast, and coarser: one
    // sample a pixel, with smoothed outlines.
    bool quick = false;
    bool validation = false;  // with VK_LAYER_KHRONOS_validation; any message is then an error
};

// width and height in pixels, 16 to 8192 each, else bad input. Without a Vulkan device: system lacks.
Result<asset::Image> render_still(const WheelView& shown, int width, int height,
                                  const StillOptions& options = {});

}  // namespace onggi::wheel

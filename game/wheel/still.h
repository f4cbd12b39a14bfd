// One finished picture of a pot on its wheel, drawn without a window: MSAA x4, exact sRGB, the same bytes
// every time on the same driver. Main thread; creates and releases its own Vulkan device.
#pragma once

#include <filesystem>
#include <memory>

#include "engine/asset/image.h"
#include "engine/core/result.h"
#include "game/haptic/messages.h"
#include "game/wheel/wheel_scene.h"

namespace onggi::wheel {

constexpr int kBeautySamples = 48;
constexpr int kMostStillPx = 8192;  // of either side, as drawn

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
    // Draws as the live window does with the CPU backend, on any device: ten times as fast, and coarser: one
    // sample per pixel, with smoothed outlines.
    bool quick = false;
    // Draws the picture so many times as large each way, and averages each pixel's block in linear light.
    int across = 1;
    bool validation = false;  // with VK_LAYER_KHRONOS_validation; any message is then an error
};

// Takes pictures of one size, one after another; shared resources are created once.
class StillCamera {
  public:
    // width and height in pixels, 16 to kMostStillPx each, else bad input; so as they are drawn. Without a
    // Vulkan device: system lacks.
    static Result<std::unique_ptr<StillCamera>> create(int width, int height,
                                                       const StillOptions& options = {});
    ~StillCamera();
    StillCamera(const StillCamera&) = delete;
    StillCamera& operator=(const StillCamera&) = delete;

    // The rest of the picture besides the snapshot. take() sets the view and the visibility of the hands.
    [[nodiscard]] WheelScene& scene();
    // Resets the hands' poses, for a picture of another pot.
    void forget();
    // With validation, any message so far is an error.
    Result<asset::Image> take(const haptic::Snapshot& snapshot, StillView view);
    // Releases the device and reports late validation messages. No picture can be taken after it.
    Result<void> close();

  private:
    StillCamera();
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

// One picture, as by a StillCamera.
Result<asset::Image> render_still(const haptic::Snapshot& snapshot, int width, int height,
                                  const StillOptions& options = {});

}  // namespace onggi::wheel

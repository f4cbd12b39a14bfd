// A series of finished pictures as in still.h. Main thread; has a Vulkan device of its own.
#pragma once

#include <memory>

#include "game/wheel/still.h"

namespace onggi::wheel {

// Takes pictures of one size, one after another; shared resources are created once.
class StillCamera {
  public:
    // width and height in pixels, 16 to 8192 each, else bad input. Without a Vulkan device: system lacks.
    static Result<std::unique_ptr<StillCamera>> create(int width, int height,
                                                       const StillOptions& options = {});
    ~StillCamera();
    StillCamera(const StillCamera&) = delete;
    StillCamera& operator=(const StillCamera&) = delete;

    // Resets the hands' poses, for a picture of another pot.
    void forget();
    // With validation, any message so far is an error.
    Result<asset::Image> take(const WheelView& given, StillView view);
    // Releases the device and reports late validation messages. No picture can be taken after it.
    Result<void> close();

  private:
    StillCamera();
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace onggi::wheel

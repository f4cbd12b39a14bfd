// Finished pictures taken one after another: see still.h, whose pictures these are. Main thread; has a Vulkan
// device of its own.
#pragma once

#include <memory>

#include "game/wheel/still.h"

namespace onggi::wheel {

// Takes one picture after another, all of one size; what they have in common is made once.
class StillCamera {
  public:
    // width and height in pixels, 16 to 8192 each, else bad input. Without a Vulkan device: system lacks.
    static Result<std::unique_ptr<StillCamera>> create(int width, int height,
                                                       const StillOptions& options = {});
    ~StillCamera();
    StillCamera(const StillCamera&) = delete;
    StillCamera& operator=(const StillCamera&) = delete;

    // The next picture is of another pot: hands are not held as they were in the one before.
    void forget();
    // With validation, a message so far is an error.
    Result<asset::Image> take(const WheelView& given, StillView view);
    // Lets the device go, and hears what validation was late to complain of. Nothing can be taken after it.
    Result<void> close();

  private:
    StillCamera();
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace onggi::wheel

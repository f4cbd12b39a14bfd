// The photographs of the room where the processor lays them: those that are shown and those that may be next.
// Main thread.
#pragma once

#include <memory>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/pixels/host_photograph.h"

namespace onggi::render {

class HostBackgrounds {
  public:
    // Reads those of the scene that are not here, and lets go of those that it has not any more. Errors: a
    // background that is not whole.
    Result<void> fit(const FrameContext& frame, const Scene& scene);
    // One of the scene's. Errors: it is none.
    [[nodiscard]] Result<const HostBackground*> find(
        const std::shared_ptr<const Background>& background) const;

  private:
    struct Resident {
        std::shared_ptr<const Background> background;  // held, so that no other can have its address
        HostBackground photographs;
    };
    std::vector<std::unique_ptr<Resident>> residents_;
};

}  // namespace onggi::render

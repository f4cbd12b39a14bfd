// The photographs of the room where the processor lays them: those that are shown and those that may be next.
// Main thread.
#pragma once

#include <memory>
#include <vector>

#include "engine/core/result.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/pixels/host_photograph.h"

namespace onggi::render {

class HostPlates {
  public:
    // Reads those of the scene that are not here, and lets go of those that it has not any more. Errors: a
    // plate that is not whole.
    Result<void> fit(const FrameContext& frame, const Scene& scene);
    // One of the scene's. Errors: it is none.
    [[nodiscard]] Result<const HostPlate*> find(const std::shared_ptr<const Plate>& plate) const;

  private:
    struct Resident {
        std::shared_ptr<const Plate> plate;  // held, so that no other can have its address
        HostPlate photographs;
    };
    std::vector<std::unique_ptr<Resident>> residents_;
};

}  // namespace onggi::render

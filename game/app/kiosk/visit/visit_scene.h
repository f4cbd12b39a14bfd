// How the scene is looked at, and what follows the clay over it frame by frame: the camera, the cue for a
// touch, the band of a warning, the forces. Main thread.
#pragma once

#include <cstdint>
#include <optional>

#include "game/app/kiosk/presentation/force_view.h"
#include "game/app/kiosk/presentation/kiosk_camera.h"
#include "game/app/kiosk/presentation/kiosk_cue.h"
#include "game/app/kiosk/visit/visit_input.h"
#include "game/app/kiosk/visit/visit_parts.h"
#include "game/app/kiosk/visit/visit_wheel.h"
#include "game/screens/stage.h"

namespace onggi::app {

// What is drawn over the scene in one frame.
struct SceneMarks {
    std::optional<screens::Band> band{};
    std::optional<screens::Cue> cue{};
    std::optional<screens::ForceFrame> forces{};
};

class VisitScene {
  public:
    // All outlive it.
    VisitScene(const VisitParts& parts, const VisitWheel& wheel, const VisitInput& input,
               const visit::VisitDrawing& drawing, const visit::VisitTrim& trim)
        : parts_(parts),
          wheel_(wheel),
          input_(input),
          drawing_(drawing),
          trim_(trim) {}

    // shown: the screen that was asked for last, null before the first. covered: nothing of the scene is seen
    // now.
    void aim_camera(const kiosk::State& state, double clay_mm, const screens::View* shown, bool covered);
    // Where the photographed room ends, as the camera was aimed last.
    [[nodiscard]] SceneEdges edges() const;
    // Once a frame.
    [[nodiscard]] SceneMarks marks(const kiosk::State& state, const VisitMoment& moment,
                                   const screens::Stage& stage);

  private:
    // What the visitor asked to see, or is being taught by; none: nothing.
    [[nodiscard]] std::optional<screens::ForceFrame> forces(const kiosk::State& state,
                                                            const haptic::Snapshot& snapshot) const;
    [[nodiscard]] std::optional<screens::Band> warning_band(const kiosk::State& state,
                                                            const haptic::Snapshot& snapshot) const;
    // A stretch of the clay from its left edge to its right, as the camera sees it; none where it sees none.
    [[nodiscard]] std::optional<screens::Band> band_round(const pot::Pot& shape, double low_mm,
                                                          double high_mm) const;
    // What of the clay the hands hold, or a touch would; none where nobody throws.
    [[nodiscard]] std::optional<screens::Cue> cue(const kiosk::State& state, const VisitMoment& moment,
                                                  const screens::Stage& stage);
    void add_way(screens::Cue& cue, const pot::Pot& shape, int step, double side) const;

    const VisitParts& parts_;
    const VisitWheel& wheel_;
    const VisitInput& input_;
    const visit::VisitDrawing& drawing_;
    const visit::VisitTrim& trim_;
    KioskCamera camera_;
    CameraRequest aimed_;  // as the view was last told
    KioskCue cue_;
    std::uint64_t cued_lump_ = 0;  // as VisitWheel::lumps_asked counts
    ForceView forces_;
};

}  // namespace onggi::app

// The camera, and the marks that follow the clay in each frame: the cue for a touch, the band of a warning,
// the forces. Main thread.
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

// The marks over the scene in one frame.
struct SceneMarks {
    std::optional<screens::Band> band{};
    std::optional<screens::Cue> cue{};
    std::optional<screens::ForceFrame> forces{};
};

class VisitScene {
  public:
    // All references must outlive it.
    VisitScene(const VisitParts& parts, const VisitWheel& wheel, const VisitInput& input,
               const visit::VisitDrawing& drawing, const visit::VisitTrim& trim)
        : parts_(parts),
          wheel_(wheel),
          input_(input),
          drawing_(drawing),
          trim_(trim) {}

    // shown: the last requested screen, null before the first. covered: the scene is completely hidden.
    void aim_camera(const kiosk::State& state, double clay_mm, const screens::View* shown, bool covered);
    // The photographed room's edges for the camera's last framing.
    [[nodiscard]] SceneEdges edges() const;
    // Call it once a frame.
    [[nodiscard]] SceneMarks marks(const kiosk::State& state, const VisitMoment& moment,
                                   const screens::Stage& stage);

  private:
    // The forces that the visitor requested or that the lesson shows, if any.
    [[nodiscard]] std::optional<screens::ForceFrame> forces(const kiosk::State& state,
                                                            const haptic::Snapshot& snapshot) const;
    [[nodiscard]] std::optional<screens::Band> warning_band(const kiosk::State& state,
                                                            const haptic::Snapshot& snapshot) const;
    // A band of the clay from its left to its right edge in the picture; nothing if it is not visible.
    [[nodiscard]] std::optional<screens::Band> band_round(const pot::Pot& shape, double low_mm,
                                                          double high_mm) const;
    // The cue of the hands' hold or of the next touch; nothing outside the throwing.
    [[nodiscard]] std::optional<screens::Cue> cue(const kiosk::State& state, const VisitMoment& moment,
                                                  const screens::Stage& stage);
    void add_way(screens::Cue& cue, const pot::Pot& shape, int step, double side) const;
    void point_at(screens::Cue& cue, const pot::Pot& shape, const dvec2& marker_mm) const;
    void place_arrow(screens::Cue& cue, screens::CueWay way, vec2 at_px, float side) const;

    const VisitParts& parts_;
    const VisitWheel& wheel_;
    const VisitInput& input_;
    const visit::VisitDrawing& drawing_;
    const visit::VisitTrim& trim_;
    KioskCamera camera_;
    CameraRequest aimed_;  // the last request to the view
    KioskCue cue_;
    std::uint64_t cued_lump_ = 0;  // number of VisitWheel::lumps_asked()
    ForceView forces_;
};

}  // namespace onggi::app

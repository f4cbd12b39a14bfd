// Trimming the foot, as the scene shows it: the pot stands upside down on its rim, with the trimmer. Maps the
// finger's position to the clay, which stays upright in the haptic loop. Main thread. mm.
#pragma once

#include <optional>

#include "game/haptic/messages.h"
#include "game/visit/flow/visit_flow.h"
#include "game/wheel/wheel_scene.h"

namespace onggi::visit {

// The least thickness of the wall above the floor that leaves clay to trim.
constexpr double kThickFootMm = 9.0;

class VisitTrim {
  public:
    // `flow` must outlive it.
    explicit VisitTrim(VisitFlow& flow) : flow_(flow) {}

    void begin(const haptic::Snapshot& snapshot);
    // Dispatches the removed mass when it changes. Call it once a frame.
    void look(const haptic::Snapshot& snapshot);
    // Converts a point of the picture's plane to the clay's frame, and back.
    [[nodiscard]] dvec2 turned(const dvec2& place_mm) const;
    // Updates the pot, the hands and the shavings in the scene.
    void show(wheel::WheelScene& scene, const haptic::Snapshot& snapshot);
    // The foot's range of heights on the pot that is shown upside down.
    struct Foot {
        double low_mm = 0.0;
        double high_mm = 0.0;
    };
    [[nodiscard]] std::optional<Foot> wanted() const;
    [[nodiscard]] const pot::Pot& pot() const { return over_; }

  private:
    [[nodiscard]] bool is_there() const;  // the pot is on its rim, perhaps under a panel

    VisitFlow& flow_;
    double begun_mm3_ = 0.0;
    double height_mm_ = 0.0;  // of the upright clay
    pot::Pot over_;
    ecs::Entity in_scene_;  // the pot on its rim
};

}  // namespace onggi::visit

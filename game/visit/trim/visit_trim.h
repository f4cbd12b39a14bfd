// Turning the foot, as a visit sees it: the pot upside down on its rim, the trimmer on it, and what a finger
// there means to the clay, which the wheel keeps upright. Main thread. mm.
#pragma once

#include <optional>

#include "game/haptic/messages.h"
#include "game/visit/flow/visit_flow.h"
#include "game/wheel/wheel_scene.h"

namespace onggi::visit {

// A wall above the floor that thick has clay to spare.
constexpr double kThickFootMm = 9.0;

class VisitTrim {
  public:
    // It outlives it.
    explicit VisitTrim(VisitFlow& flow) : flow_(flow) {}

    void begin(const haptic::Snapshot& snapshot);
    // Tells the visit how much was taken. Once a frame.
    void look(const haptic::Snapshot& snapshot);
    // What a place on the picture's plane is to the clay, and the other way round.
    [[nodiscard]] dvec2 turned(const dvec2& place_mm) const;
    // The pot, the hands and the shavings as they are seen then.
    void show(wheel::WheelScene& scene, const haptic::Snapshot& snapshot);
    // Where the foot should come, of the pot that is shown: from there to there.
    struct Foot {
        double low_mm = 0.0;
        double high_mm = 0.0;
    };
    [[nodiscard]] std::optional<Foot> wanted() const;
    [[nodiscard]] const pot::Pot& pot() const { return over_; }

  private:
    [[nodiscard]] bool is_there() const;  // the pot on its rim, under a panel too

    VisitFlow& flow_;
    double begun_mm3_ = 0.0;
    double height_mm_ = 0.0;  // of the clay, upright
    pot::Pot over_;
    ecs::Entity in_scene_;  // that pot
};

}  // namespace onggi::visit

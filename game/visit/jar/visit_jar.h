// A jar of two bowls in the making, as the scene shows it: the outline over the clay, the bowl that was set
// aside, and both bowls held together. Main thread. mm.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "game/haptic/messages.h"
#include "game/heritage/target.h"
#include "game/pot/section.h"
#include "game/visit/flow/step.h"
#include "game/visit/flow/visit_flow.h"
#include "game/wheel/wheel_scene.h"

namespace onggi::visit {

class VisitJar {
  public:
    // All references must outlive it. `places` maps State::throwing.target to rows of `targets`.
    VisitJar(const std::vector<heritage::Target>& targets, const std::vector<std::size_t>& places,
             VisitFlow& flow)
        : targets_(targets),
          places_(places),
          flow_(flow) {}

    void set_aside(std::shared_ptr<const pot::Pot> bowl);
    void forget();
    // Dispatches an event when the clay on the wheel becomes or stops being usable as a bowl of the jar. Call
    // it once a frame.
    void look(const haptic::Snapshot& snapshot);

    // The id of the target, or empty.
    [[nodiscard]] std::string target_id() const;
    // The target's outline as radius and height of the wet clay, bottom to top; may be empty. For a jar it is
    // the bowl's outline; for the second bowl, that of the thrown first bowl.
    [[nodiscard]] std::vector<vec2> outline() const;
    // The bowl beside the wheel, or null.
    [[nodiscard]] std::shared_ptr<const pot::Section> aside() const;
    // The offset (x, z) of the upper bowl in the clay's frame, for a wheel with this heading.
    [[nodiscard]] dvec2 shift_mm(const dvec2& heading) const;
    // Outer diameter at which the upper bowl's foot is cut open.
    [[nodiscard]] double mouth_mm() const;
    // Height of the clay visible on the wheel, with the upper bowl while both are held together.
    [[nodiscard]] double height_mm(const haptic::Snapshot& snapshot) const;
    // Updates the bowl that was set aside in the scene: beside the wheel, or over the clay while both are
    // held together.
    void show(wheel::WheelScene& scene, const haptic::Snapshot& snapshot);

  private:
    // True also while a panel is open.
    [[nodiscard]] bool works_on(Finger what) const;
    [[nodiscard]] const heritage::Target* target() const;

    const std::vector<heritage::Target>& targets_;
    const std::vector<std::size_t>& places_;
    VisitFlow& flow_;
    std::shared_ptr<const pot::Pot> bowl_;
    std::shared_ptr<const pot::Section> bowl_section_;
    ecs::Entity in_scene_;  // the bowl
};

}  // namespace onggi::visit

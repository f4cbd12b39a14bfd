// A jar of two bowls in the making, as a visit sees it: the outline that is shown over the clay, the bowl
// that was set aside, and the two held together. Main thread. mm.
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
    // All outlive it. places: of State::throwing.target, in the table of targets.
    VisitJar(const std::vector<heritage::Target>& targets, const std::vector<std::size_t>& places,
             VisitFlow& flow)
        : targets_(targets),
          places_(places),
          flow_(flow) {}

    void set_aside(std::shared_ptr<const pot::Pot> bowl);
    void forget();
    // Tells the visit whether the clay on the wheel could be a half of the jar. Once a frame.
    void look(const haptic::Snapshot& snapshot);

    // Of the museum's pot that is thrown after; empty: none.
    [[nodiscard]] std::string target_id() const;
    // What is thrown after: radius and height of the wet clay, from below; empty: nothing. Of a jar the bowl,
    // and for the second bowl the first as it came out.
    [[nodiscard]] std::vector<vec2> outline() const;
    // The bowl that was set aside, while it stands beside the wheel; null: none does.
    [[nodiscard]] std::shared_ptr<const pot::Section> aside() const;
    // Where the upper bowl is held: x and z, in the clay's frame of a wheel that stands so.
    [[nodiscard]] dvec2 shift_mm(const dvec2& heading) const;
    // Across and outside, where the upper bowl's foot is to be cut open.
    [[nodiscard]] double mouth_mm() const;
    // Of what is seen on the wheel.
    [[nodiscard]] double height_mm(const haptic::Snapshot& snapshot) const;
    // The bowl that was set aside is in the scene; over the clay while they are held together.
    void show(wheel::WheelScene& scene, const haptic::Snapshot& snapshot);

  private:
    // Also under a panel.
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

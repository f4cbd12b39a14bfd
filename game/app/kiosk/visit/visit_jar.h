// A jar of two bowls in the making, as a visit sees it: the outline that is shown over the clay, the bowl
// that was set aside, and the two held together. Main thread. mm.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "game/app/kiosk/visit/visit_parts.h"
#include "game/pot/section.h"
#include "game/wheel/wheel_scene.h"

namespace onggi::app {

class VisitJar {
  public:
    // Both outlive it.
    VisitJar(const VisitParts& parts, VisitFlow& flow) : parts_(parts), flow_(flow) {}

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
    // How the bowls are to be joined, on a wheel that stands so.
    [[nodiscard]] JarJoin join(const dvec2& heading) const;
    // Of what is seen on the wheel.
    [[nodiscard]] double height_mm(const haptic::Snapshot& snapshot) const;
    // The bowl that was set aside is in the scene; over the clay while they are held together.
    void show(wheel::WheelScene& scene, const haptic::Snapshot& snapshot);

  private:
    [[nodiscard]] const heritage::Target* target() const;

    const VisitParts& parts_;
    VisitFlow& flow_;
    std::shared_ptr<const pot::Pot> bowl_;
    std::shared_ptr<const pot::Section> bowl_section_;
    ecs::Entity in_scene_;  // the bowl
};

}  // namespace onggi::app

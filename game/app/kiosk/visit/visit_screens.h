// Builds the View for the screens, and sends it on if it differs from the last. Main thread.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "game/app/kiosk/finger/kiosk_pointer.h"
#include "game/app/kiosk/presentation/kiosk_camera.h"
#include "game/app/kiosk/staff/staff_desk.h"
#include "game/app/kiosk/visit/visit_effects.h"
#include "game/app/kiosk/visit/visit_parts.h"
#include "game/screens/composer.h"
#include "game/visit/steps.h"

namespace onggi::app {

class VisitScreens {
  public:
    // All references must outlive it.
    VisitScreens(const VisitParts& parts, const VisitEffects& effects, const visit::VisitJar& jar,
                 const KioskPointer& pointer, StaffDesk& desk)
        : parts_(parts),
          effects_(effects),
          jar_(jar),
          pointer_(pointer),
          desk_(desk) {}

    Result<void> start() { return composer_.start(); }
    void stop() noexcept { composer_.stop(); }

    // Whether the museum is closed and there is no visitor.
    [[nodiscard]] bool is_closed(const kiosk::State& state) const;
    // Call it once a frame. edges: the photographed room's. wire_mm: the height of the held wire.
    void update(const kiosk::State& state, const VisitMoment& moment, const SceneEdges& edges,
                const std::optional<double>& wire_mm);
    // The last requested view; null before the first.
    [[nodiscard]] const screens::View* asked() const { return asked_.get(); }
    [[nodiscard]] screens::Composer& composer() { return composer_; }

  private:
    void add_attract(screens::View& view, const kiosk::State& state, double now_s) const;
    void add_scene(screens::View& view, const kiosk::State& state, const haptic::Snapshot& snapshot) const;
    void add_aside(screens::View& view) const;
    void add_wire(screens::View& view, const haptic::Snapshot& snapshot,
                  const std::optional<double>& wire_mm) const;
    void add_shelf(screens::View& view, const kiosk::State& state);
    // Whether it equals the last requested view, except for invisibly small motion.
    [[nodiscard]] bool is_asked(screens::View& view) const;
    const std::string& caption(const VisitMoment& moment);  // key of the sound's caption

    const VisitParts& parts_;
    const VisitEffects& effects_;
    const visit::VisitJar& jar_;
    const KioskPointer& pointer_;
    StaffDesk& desk_;
    screens::Composer composer_{visit::compose};
    std::shared_ptr<const screens::View> asked_;
    std::shared_ptr<const std::vector<screens::ShelfPot>> shelf_;
    std::uint64_t shelf_kept_ =
        0;  // pots_kept() when the shelf was built, and whether it left out the newest
    bool shelf_without_newest_ = false;
    std::string caption_;
    double caption_s_ = 0.0;  // start time
};

}  // namespace onggi::app

// What of the haptic loop's newest snapshot the picture shows as forces: where each hand touches, an arrow
// for each force of Fig. 6, the rings in contact, and how force and tick rate went. Main thread, once a
// frame. mm, N.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "game/haptic/messages.h"
#include "game/screens/forces.h"
#include "game/wheel/live_view.h"

namespace onggi::app {

// As the camera sees it.
struct Sight {
    std::function<std::optional<dvec2>(const dvec3&)> project;  // pixels; nothing behind the eye
    std::function<dvec3(const dvec3&)> towards_eye;             // unit length
};
[[nodiscard]] Sight sight_of(const wheel::LiveView& view);

// F_s, F_v, F_f and their sum, in the order of screens::Force.
using Forces = std::array<dvec3, screens::kForceCount>;
[[nodiscard]] Forces forces_of(const clay::ContactForces& forces);

// Where the tool touches: the clay pushes from there straight through the tool's centre. The centre itself
// where it does not push.
[[nodiscard]] dvec3 touched_mm(const dvec3& tool_mm, double radius_mm, const dvec3& stiffness_n);

// The rings of the shape in contact, as [first, end): those whose middle lies in the stretch that is touched.
struct RingSpan {
    int first = 0;
    int end = 0;
    [[nodiscard]] int size() const { return end - first; }
};
[[nodiscard]] RingSpan rings_touched(const pot::Pot& shape, const clay::ContactForces& forces);

class ForceView {
  public:
    // An arrow that is as long as the plot is high has this length.
    static constexpr double kFullArrowMm = 80.0;

    // now_s ascends. What is shown follows the forces within some hundredths of a second, so that it can be
    // read; the plot has each as it was.
    void look(const haptic::Snapshot& snapshot, double now_s);
    // Of the snapshot that was looked at last. with_sum: the sum too, else the three alone.
    [[nodiscard]] screens::ForceFrame frame(const haptic::Snapshot& snapshot, const Sight& sight,
                                            bool with_sum) const;

    [[nodiscard]] double mm_per_n() const { return kFullArrowMm / full_n_; }
    [[nodiscard]] const screens::ForceTrace& trace() const { return trace_; }

  private:
    screens::ForceTrace trace_;
    std::array<Forces, 2> shown_n_{};  // of both hands
    double full_n_ = 0.1;
    double last_s_ = 0.0;
};

}  // namespace onggi::app

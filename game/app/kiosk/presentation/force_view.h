// The force view of the haptic loop's newest snapshot: each hand's contact, an arrow for each force of Fig.
// 6, the touched rings, and the course of force and tick rate. Main thread, once a frame. mm, N.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "game/haptic/messages.h"
#include "game/screens/forces.h"
#include "game/wheel/live_view.h"

namespace onggi::app {

// The camera's projection.
struct Sight {
    std::function<std::optional<dvec2>(const dvec3&)> project;  // pixels; nothing behind the camera
    std::function<dvec3(const dvec3&)> towards_eye;             // unit length
};
[[nodiscard]] Sight sight_of(const wheel::LiveView& view);

// F_s, F_v, F_f and their sum, in the order of screens::Force.
using Forces = std::array<dvec3, screens::kForceCount>;
[[nodiscard]] Forces forces_of(const clay::ContactForces& forces);

// The tool's contact point: the clay pushes from there towards the tool's centre. Returns the centre without
// a force.
[[nodiscard]] dvec3 touched_mm(const dvec3& tool_mm, double radius_mm, const dvec3& stiffness_n);

// The touched rings of the shape, as [first, end): those whose middle is in the contact's height range.
struct RingSpan {
    int first = 0;
    int end = 0;
    [[nodiscard]] int size() const { return end - first; }
};
[[nodiscard]] RingSpan rings_touched(const pot::Pot& shape, const clay::ContactForces& forces);

class ForceView {
  public:
    // The length of an arrow for a force of the plot's full height.
    static constexpr double kFullArrowMm = 80.0;

    // now_s must ascend. Smooths the shown forces over some hundredths of a second, so that they are
    // readable; the plot has the raw values.
    void look(const haptic::Snapshot& snapshot, double now_s);
    // The forces of the last snapshot. with_sum: adds the sum to the three parts.
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

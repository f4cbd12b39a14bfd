// The kiosk's wheel under a visitor's pointer: from the window's events by the kiosk's own pointer and hand,
// the device behind it and the tick to the clay, a virtual clock throughout. Only the picture is missing; the
// pointer's pixels lie on the clay's plane as they do on a screen 1280 wide.
#pragma once

#include <vector>

#include "game/app/kiosk/finger/kiosk_finger.h"
#include "game/app/kiosk/finger/kiosk_pointer.h"
#include "game/app/kiosk/presentation/kiosk_pot.h"
#include "game/haptic/simulated_device.h"
#include "game/haptic/tick.h"
#include "tests/visitors/wheel_rig.h"

namespace onggi::visitors {

class KioskRig final : public WheelRig {
  public:
    explicit KioskRig(double mass_g);

    // Radius and height from below; empty: none. The kiosk helps along it, less with each step of the lesson.
    void show_outline(const std::vector<dvec2>& outline_mm);
    void frame(const dvec2& pointer_mm, bool pressed) override;
    [[nodiscard]] double height_mm() const override { return clay().height_mm(); }
    [[nodiscard]] double floor_mm() const override { return clay().floor_mm(); }
    [[nodiscard]] double outer_mm(double y_mm) const override;
    [[nodiscard]] double inner_mm(double y_mm) const override;

    [[nodiscard]] const clay::StudioClay& clay() const { return *state_.studio(); }
    // Both faces of every ring, bottom first, as they were when the pointer was last let go.
    [[nodiscard]] const std::vector<double>& released_mm() const { return released_mm_; }
    [[nodiscard]] std::vector<double> faces_mm() const;

  private:
    app::KioskPointer pointer_;
    app::KioskFinger finger_;
    haptic::SimulatedDevice device_;
    haptic::HapticParameters parameters_;
    haptic::HapticState state_;
    pot::Pot shape_;
    app::Lesson lesson_;
    std::vector<vec2> outline_mm_;
    std::vector<double> released_mm_;
    bool was_pressed_ = false;
    double now_s_ = 0.0;
    std::uint64_t ticks_ = 0;
};

}  // namespace onggi::visitors

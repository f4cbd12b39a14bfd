// The kiosk's wheel under a visitor's pointer: window events pass through the kiosk's pointer, the flow of
// the throwing screen, hand, device and tick to the clay, on a virtual clock. There is no picture; pixels map
// to the clay's plane as on a screen 1280 wide, with the tools of the bench where that screen shows them.
#pragma once

#include <optional>
#include <vector>

#include "game/app/kiosk/finger/kiosk_finger.h"
#include "game/app/kiosk/finger/kiosk_pointer.h"
#include "game/app/kiosk/presentation/kiosk_pot.h"
#include "game/app/kiosk/visit/bench_tools.h"
#include "game/haptic/simulated_device.h"
#include "game/haptic/tick.h"
#include "game/kiosk/events.h"
#include "game/kiosk/rules.h"
#include "tests/visitors/wheel_rig.h"

namespace onggi::visitors {

class KioskRig final : public WheelRig {
  public:
    explicit KioskRig(double mass_g);

    // Shows an outline, radius and height from below; empty: no outline. The kiosk assists along it, less
    // with each step of the lesson.
    void show_outline(const std::vector<dvec2>& outline_mm);
    void frame(const dvec2& pointer_mm, bool pressed) override;
    Advice press_done() override;
    [[nodiscard]] double height_mm() const override { return clay().height_mm(); }
    [[nodiscard]] double floor_mm() const override { return clay().floor_mm(); }
    [[nodiscard]] double outer_mm(double y_mm) const override;
    [[nodiscard]] double inner_mm(double y_mm) const override;

    [[nodiscard]] int steps_done() const override { return visit_.throwing.steps_done; }
    [[nodiscard]] bool shows() const override { return finger_.shows(); }

    [[nodiscard]] const pot::Pot& shape() const { return shape_; }
    [[nodiscard]] const clay::StudioClay& clay() const { return *state_.studio(); }
    // The clay when "done" was pressed for the first time, or as it is.
    [[nodiscard]] const clay::StudioClay& clay_at_done() const { return at_done_ ? *at_done_ : clay(); }
    // Both faces of every ring, bottom first, at the last release of the pointer or the end of
    // the last demonstration.
    [[nodiscard]] const std::vector<double>& released_mm() const { return released_mm_; }
    [[nodiscard]] std::vector<double> faces_mm() const;

  private:
    void dispatch(const kiosk::Event& event);

    kiosk::State visit_;
    kiosk::Rules rules_;
    app::KioskPointer pointer_;
    app::BenchTouch bench_;
    app::KioskFinger finger_;
    haptic::SimulatedDevice device_;
    haptic::HapticParameters parameters_;
    haptic::HapticState state_;
    std::optional<clay::StudioClay> at_done_;
    pot::Pot shape_;
    app::Lesson lesson_;
    std::vector<vec2> outline_mm_;
    std::vector<double> released_mm_;
    bool was_pressed_ = false;
    double now_s_ = 0.0;
    std::uint64_t ticks_ = 0;
};

}  // namespace onggi::visitors

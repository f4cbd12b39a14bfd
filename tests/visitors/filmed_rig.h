// The whole kiosk under a visitor's pointer, filmed: the real view, screens and job, in real time, because
// the job runs in real time. mm, s, pixels.
#pragma once

#include <filesystem>
#include <vector>

#include "tests/stress/unseen_kiosk.h"
#include "tests/visitors/wheel_rig.h"

namespace onggi::visitors {

constexpr int kFilmWidth = 640;
constexpr int kFilmHeight = 360;

class FilmedRig final : public WheelRig {
  public:
    struct Shot {
        double at_s = 0.0;  // since the clay was put on
        bool pressed = false;
        asset::Image picture;  // with a cross where the pointer is
    };

    // Starts a visit and puts clay on the wheel. Takes a picture every `every_s`.
    FilmedRig(const std::filesystem::path& gallery, double every_s);

    void frame(const dvec2& pointer_mm, bool pressed) override;
    [[nodiscard]] double height_mm() const override { return shape().height_mm; }
    [[nodiscard]] double floor_mm() const override { return shape().floor_mm; }
    [[nodiscard]] double outer_mm(double y_mm) const override;
    [[nodiscard]] double inner_mm(double y_mm) const override;

    [[nodiscard]] int steps_done() const override { return kiosk_.state().throwing.steps_done; }
    [[nodiscard]] bool shows() const override { return kiosk_.state().throwing.shown.has_value(); }

    // Films the rest of the visit, from "Done" to the kept pot and its page. Returns whether it got there.
    bool finishes();

    [[nodiscard]] const std::vector<Shot>& film() const { return film_; }

  private:
    [[nodiscard]] const pot::Pot& shape() const { return *kiosk_.snapshot().pot; }
    // A frame in real time.
    void pass_frame();
    // Waits until that screen is there, and looks at it for some seconds.
    bool comes_to(kiosk::Screen screen, double looks_s);
    void take_picture(const dvec2& pointer_px, bool pressed);

    mutable app::UnseenKiosk kiosk_;  // reading the newest snapshot consumes it
    double every_s_;
    double began_s_ = 0.0;
    double next_s_ = 0.0;
    std::chrono::steady_clock::time_point last_{};
    bool was_pressed_ = false;
    std::vector<Shot> film_;
};

}  // namespace onggi::visitors

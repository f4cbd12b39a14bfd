// How a camera goes from one place to another: in a second and no more, neither starting nor stopping with a
// jerk, the same however many frames that second has. Any thread; pure. mm, rad, s.
#pragma once

#include <array>

#include "engine/render/camera.h"

namespace onggi::wheel {

// One number on its way to a goal: a spring that is damped just so that it never swings past.
struct Settling {
    double value = 0.0;
    double speed = 0.0;  // a second

    friend bool operator==(const Settling&, const Settling&) = default;
};
// After dt_s seconds; exact for any step. After 5 / rate_per_s about 96 % of the way is done.
[[nodiscard]] Settling settled(const Settling& now, double goal, double rate_per_s, double dt_s);

// One number on its way to a goal where it will stand still.
struct Travelling {
    double value = 0.0;
    double speed = 0.0;         // a second
    double acceleration = 0.0;  // a second squared
};
// After this fraction, 0 to 1, of the whole way's seconds, the way of the least jerk.
[[nodiscard]] Travelling travelled(const Travelling& from, double goal, double fraction, double whole_s);

// Where in the picture the background's own picture is put: the design of a screen leaves it more or less
// room.
struct Framing {
    dvec2 shift{0.0};   // of the picture, in halves of it, x right and y down
    double zoom = 1.0;  // of the background about its middle, before it is shifted

    friend bool operator==(const Framing&, const Framing&) = default;
};

// A camera about the wheel's axis. It turns about it rather than cutting through the pot.
struct CameraPose {
    double azimuth_rad = 0.0;  // 0 looks along -Z
    double out_mm = 1000.0;    // from the axis
    double up_mm = 300.0;      // over the wheel head
    dvec3 target_mm{0.0};
    double vertical_fov_rad = 0.5;
    dvec2 lens_shift{0.0};  // as render::Camera's

    friend bool operator==(const CameraPose&, const CameraPose&) = default;
};
[[nodiscard]] CameraPose pose_of(const render::Camera& camera);
[[nodiscard]] render::Camera camera_at(const CameraPose& pose);

class CameraMotion {
  public:
    void jump_to(const CameraPose& pose);
    // From wherever it is, with whatever speed it has; the way to another goal takes as long again.
    void go_to(const CameraPose& pose);
    void advance(double dt_s);

    [[nodiscard]] CameraPose pose() const;
    // It stands exactly at its goal.
    [[nodiscard]] bool at_rest() const { return left_s_ <= 0.0; }

  private:
    static constexpr std::size_t kNumbers = 9;
    using Numbers = std::array<double, kNumbers>;
    static Numbers values_of(const CameraPose& pose);
    void arrive();

    std::array<Travelling, kNumbers> from_{};
    std::array<Travelling, kNumbers> now_{};
    Numbers goal_{};
    double left_s_ = 0.0;  // of the way to the goal
};

// How far `pose` has come from one pose to another, 0 to 1: the fraction of the second background in a glide.
// Eased, so that each background is seen alone near its own camera.
[[nodiscard]] double fraction_between(const CameraPose& from, const CameraPose& to, const CameraPose& pose);

}  // namespace onggi::wheel

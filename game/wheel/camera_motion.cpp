#include "game/wheel/camera_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace onggi::wheel {
namespace {

constexpr double kTransitionS = 1.1;

}  // namespace

Settling settled(const Settling& now, double goal, double rate_per_s, double dt_s) {
    // x'' = -2 r x' - r^2 x about the goal, solved: (x0 + (v0 + r x0) t) exp(-r t).
    const double away = now.value - goal;
    const double push = now.speed + rate_per_s * away;
    const double decay = std::exp(-rate_per_s * dt_s);
    return {.value = goal + (away + push * dt_s) * decay,
            .speed = (now.speed - rate_per_s * push * dt_s) * decay};
}

Travelling travelled(const Travelling& from, double goal, double fraction, double whole_s) {
    // A polynomial of the fifth degree of the fraction s: value, speed and acceleration here, and none but
    // the goal's value there. T. Flash, N. Hogan, "The coordination of arm movements", 1985.
    const double away = goal - from.value;
    const double speed = from.speed * whole_s;
    const double push = 0.5 * from.acceleration * whole_s * whole_s;
    const double c3 = 10.0 * away - 6.0 * speed - 3.0 * push;
    const double c4 = -15.0 * away + 8.0 * speed + 3.0 * push;
    const double c5 = 6.0 * away - 3.0 * speed - push;
    const double s = fraction;
    return {.value = from.value + s * (speed + s * (push + s * (c3 + s * (c4 + s * c5)))),
            .speed = (speed + s * (2.0 * push + s * (3.0 * c3 + s * (4.0 * c4 + s * 5.0 * c5)))) / whole_s,
            .acceleration =
                (2.0 * push + s * (6.0 * c3 + s * (12.0 * c4 + s * 20.0 * c5))) / (whole_s * whole_s)};
}

CameraPose pose_of(const render::Camera& camera) {
    const dvec3 eye(camera.eye_mm);
    return {.azimuth_rad = std::atan2(eye.x, eye.z),
            .out_mm = std::hypot(eye.x, eye.z),
            .up_mm = eye.y,
            .target_mm = dvec3(camera.target_mm),
            .vertical_fov_rad = static_cast<double>(camera.vertical_fov_rad),
            .lens_shift = dvec2(camera.lens_shift)};
}

render::Camera camera_at(const CameraPose& pose) {
    const dvec3 eye(pose.out_mm * std::sin(pose.azimuth_rad), pose.up_mm,
                    pose.out_mm * std::cos(pose.azimuth_rad));
    const double distance = glm::length(eye - pose.target_mm);
    return {.eye_mm = vec3(eye),
            .target_mm = vec3(pose.target_mm),
            .vertical_fov_rad = static_cast<float>(pose.vertical_fov_rad),
            .near_mm = static_cast<float>(0.2 * distance),
            .far_mm = static_cast<float>(20.0 * distance),
            .lens_shift = vec2(pose.lens_shift)};
}

CameraMotion::Numbers CameraMotion::values_of(const CameraPose& pose) {
    return {pose.azimuth_rad, pose.out_mm,           pose.up_mm,        pose.target_mm.x, pose.target_mm.y,
            pose.target_mm.z, pose.vertical_fov_rad, pose.lens_shift.x, pose.lens_shift.y};
}

void CameraMotion::jump_to(const CameraPose& pose) {
    goal_ = values_of(pose);
    arrive();
}

void CameraMotion::go_to(const CameraPose& pose) {
    const Numbers goal = values_of(pose);
    if (goal == goal_) return;
    goal_ = goal;
    // The short way round.
    const double turn = 2.0 * std::numbers::pi;
    now_[0].value += turn * std::round((goal_[0] - now_[0].value) / turn);
    from_ = now_;
    left_s_ = kTransitionS;
}

void CameraMotion::advance(double dt_s) {
    if (at_rest()) return;
    left_s_ -= dt_s;
    if (at_rest()) return arrive();
    for (std::size_t i = 0; i < kNumbers; ++i)
        now_[i] = travelled(from_[i], goal_[i], 1.0 - left_s_ / kTransitionS, kTransitionS);
}

void CameraMotion::arrive() {
    for (std::size_t i = 0; i < kNumbers; ++i)
        now_[i] = {.value = goal_[i]};
    left_s_ = 0.0;
}

CameraPose CameraMotion::pose() const {
    return {.azimuth_rad = now_[0].value,
            .out_mm = now_[1].value,
            .up_mm = now_[2].value,
            .target_mm = {now_[3].value, now_[4].value, now_[5].value},
            .vertical_fov_rad = now_[6].value,
            .lens_shift = {now_[7].value, now_[8].value}};
}

double fraction_between(const CameraPose& from, const CameraPose& to, const CameraPose& pose) {
    const dvec2 whole(to.out_mm - from.out_mm, to.up_mm - from.up_mm);
    const dvec2 done(pose.out_mm - from.out_mm, pose.up_mm - from.up_mm);
    const double length = glm::dot(whole, whole);
    if (length == 0.0) return 0.0;
    const double along = glm::dot(done, whole) / length;
    const double eased = std::clamp((along - 0.25) / 0.5, 0.0, 1.0);
    return eased * eased * (3.0 - 2.0 * eased);
}

}  // namespace onggi::wheel

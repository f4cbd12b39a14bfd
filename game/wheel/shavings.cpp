#include "game/wheel/shavings.h"

#include <algorithm>
#include <cmath>

namespace onggi::wheel {
namespace {

constexpr double kGravityMmS2 = 9810.0;
// From assets/workshop/maker/wheel.py: radius of the head, and level of the slip in the pan.
constexpr double kHeadMm = 147.0;
constexpr double kSlipMm = -55.8;
constexpr double kPanMm = 188.0;
// Shavings hardly grip the head.
constexpr double kDragged = 0.8;  // fraction of the head's turning
constexpr double kSlidesMmS = 60.0;
constexpr double kHalfThickMm = 3.0;  // of a curl

double out_mm(const dvec3& at_mm) {
    return std::hypot(at_mm.x, at_mm.z);
}

// Turns a place about the axis, counter-clockwise from above, and sets its distance from the axis.
dvec3 carried(const dvec3& at_mm, double turn_rad, double radius_mm) {
    const double angle = std::atan2(-at_mm.z, at_mm.x) + turn_rad;
    return {radius_mm * std::cos(angle), at_mm.y, -radius_mm * std::sin(angle)};
}

dvec3 wall_velocity_mm_s(const dvec3& at_mm, double wheel_speed_rad_s) {
    return wheel_speed_rad_s * dvec3(at_mm.z, 0.0, -at_mm.x);
}

double between(double least, double most, std::minstd_rand& chance) {
    return std::uniform_real_distribution<double>(least, most)(chance);
}

}  // namespace

// A curl leaves along the blade: outwards, with part of the wall's velocity.
Shavings::Curl Shavings::cut_off(const ShavingSight& sight) {
    const double side = std::signbit(sight.from_mm.x) ? -1.0 : 1.0;
    const dvec3 wall_mm_s = wall_velocity_mm_s(sight.from_mm, sight.wheel_speed_rad_s);
    const auto any = [this](double least, double most) { return between(least, most, chance_); };
    return {.at_mm = sight.from_mm + dvec3(side * 4.0, any(-3.0, 3.0), any(-3.0, 5.0)),
            .velocity_mm_s = any(0.05, 0.25) * wall_mm_s +
                             dvec3(side * any(60.0, 260.0), any(-40.0, 260.0), any(-20.0, 160.0)),
            .yaw_rad = any(-3.1, 3.1),
            .roll_rad = any(-3.1, 3.1),
            .spin_rad_s = any(-14.0, 14.0),
            .size = any(0.7, 1.25)};
}

void Shavings::follow(const ShavingSight& sight, double dt_s, bool moves_less) {
    if (sight.shaved_mm3 <= 0.0) {
        curls_.clear();
        shown_mm3_ = 0.0;
    }
    if (dt_s <= 0.0) return;
    shown_mm3_ = std::min(shown_mm3_, sight.shaved_mm3);
    // After a stalled picture the backlog does not appear as a heap at once.
    shown_mm3_ = std::max(shown_mm3_, sight.shaved_mm3 - static_cast<double>(kMost) * kCurlMm3);
    for (; sight.shaved_mm3 - shown_mm3_ >= kCurlMm3; shown_mm3_ += kCurlMm3) {
        curls_.push_back(cut_off(sight));
        if (!moves_less) continue;
        Curl& curl = curls_.back();
        curl.at_mm = carried(dvec3(1.0, kSlipMm + kHalfThickMm, 0.0), between(-3.1, 3.1, chance_),
                             between(kHeadMm + 8.0, kPanMm, chance_));
        curl.stage = Stage::kInPan;
    }
    if (curls_.size() > kMost)
        curls_.erase(curls_.begin(), curls_.end() - static_cast<std::ptrdiff_t>(kMost));

    for (Curl& curl : curls_) {
        const double was_mm = curl.at_mm.y;
        switch (curl.stage) {
            case Stage::kFlies:
                curl.velocity_mm_s.y -= kGravityMmS2 * dt_s;
                curl.at_mm += curl.velocity_mm_s * dt_s;
                curl.yaw_rad += curl.spin_rad_s * dt_s;
                curl.roll_rad += 0.7 * curl.spin_rad_s * dt_s;
                if (was_mm >= kHalfThickMm && curl.at_mm.y < kHalfThickMm && out_mm(curl.at_mm) < kHeadMm) {
                    curl.at_mm.y = kHalfThickMm;
                    curl.roll_rad = 0.0;
                    curl.stage = Stage::kOnHead;
                } else if (curl.at_mm.y < kSlipMm + kHalfThickMm) {
                    curl.at_mm.y = kSlipMm + kHalfThickMm;
                    curl.at_mm = carried(curl.at_mm, 0.0, std::min(out_mm(curl.at_mm), kPanMm));
                    curl.roll_rad = 0.0;
                    curl.stage = Stage::kInPan;
                }
                break;
            case Stage::kOnHead: {
                const double turns_rad_s = kDragged * sight.wheel_speed_rad_s;
                const bool turns = std::abs(turns_rad_s) > 0.1;
                curl.at_mm = carried(curl.at_mm, turns_rad_s * dt_s,
                                     out_mm(curl.at_mm) + (turns ? kSlidesMmS * dt_s : 0.0));
                curl.yaw_rad += turns_rad_s * dt_s;
                if (out_mm(curl.at_mm) < kHeadMm) break;
                curl.velocity_mm_s = kSlidesMmS / kHeadMm * dvec3(curl.at_mm.x, 0.0, curl.at_mm.z);
                curl.stage = Stage::kFlies;
                break;
            }
            case Stage::kInPan:
                break;
        }
    }
}

std::vector<mat4> Shavings::places() const {
    std::vector<mat4> places;
    for (const Curl& curl : curls_) {
        dmat4 place = glm::translate(dmat4(1.0), curl.at_mm);
        place = glm::rotate(place, curl.yaw_rad, dvec3(0.0, 1.0, 0.0));
        place = glm::rotate(place, curl.roll_rad, dvec3(1.0, 0.0, 0.0));
        places.emplace_back(glm::scale(place, dvec3(curl.size)));
    }
    return places;
}

void Splash::follow(const SplashSight& sight, double dt_s, bool moves_less) {
    constexpr double kUsualRadS = 4.0 * kPi;  // 120 rev/min
    if (dt_s <= 0.0 || moves_less) return;
    for (Drop& drop : drops_) {
        drop.velocity_mm_s.y -= kGravityMmS2 * dt_s;
        drop.at_mm += drop.velocity_mm_s * dt_s;
    }
    std::erase_if(drops_, [](const Drop& drop) {
        return drop.at_mm.y < (out_mm(drop.at_mm) < kHeadMm ? 0.0 : kSlipMm);
    });
    const auto any = [this](double least, double most) { return between(least, most, chance_); };
    const double speed = std::min(std::abs(sight.wheel_speed_rad_s) / kUsualRadS, 2.0);
    // A stalled picture does not owe a shower.
    owed_ = std::min(owed_ + kDropsPerS * sight.film * speed * dt_s, 4.0);
    for (; owed_ >= 1.0; owed_ -= 1.0) {
        const dvec3 outwards =
            dvec3(sight.from_mm.x, 0.0, sight.from_mm.z) / std::max(out_mm(sight.from_mm), 1.0);
        drops_.push_back(
            {.at_mm = sight.from_mm + any(1.0, 4.0) * outwards,
             .velocity_mm_s = any(0.4, 0.9) * wall_velocity_mm_s(sight.from_mm, sight.wheel_speed_rad_s) +
                              any(80.0, 320.0) * outwards + dvec3(0.0, any(-60.0, 420.0), 0.0),
             .size = any(0.5, 1.3)});
    }
}

std::vector<mat4> Splash::places() const {
    std::vector<mat4> places;
    for (const Drop& drop : drops_)
        places.emplace_back(glm::scale(glm::translate(dmat4(1.0), drop.at_mm), dvec3(drop.size)));
    return places;
}

}  // namespace onggi::wheel

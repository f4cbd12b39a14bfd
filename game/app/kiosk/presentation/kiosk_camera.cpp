#include "game/app/kiosk/presentation/kiosk_camera.h"

#include <algorithm>
#include <cmath>

#include "game/screens/page/layout.h"
#include "game/visit/flow/step.h"

namespace onggi::app {
namespace {

using screens::Shape;
using wheel::Framing;
using wheel::View;

constexpr double kTopU = 56.0;        // top of the box of pot and hands
constexpr double kReachTopU = 230.0;  // the top with low controls, so that seated visitors reach the clay
constexpr double kLowerU = 110.0;     // additional lowering of the wheel with low controls
constexpr double kAirU = 10.0;
constexpr double kLeastZoom = 0.64;
constexpr double kHeadZoom = 0.8;  // limit of zooming out to show the whole wheel head
constexpr double kHeadRadiusMm = 150.0;
constexpr double kHeadEdgeMm = 22.0;  // thickness of the wheel head
constexpr double kFootMm = 60.0;
constexpr double kHandMm = 15.0;  // room for a hand above the rim
// The framing changes in steps, so that a growing pot does not move the camera in every frame.
constexpr double kFitStepMm = 24.0;
constexpr double kLeastFitMm = 150.0;

// The lens shift that moves a point from `from` to `to` (px from the middle, for an unshifted lens).
double shift_for(double from_px, double to_px, double zoom, double half_px) {
    return (to_px - half_px - from_px * zoom) / half_px;
}

class Framer {
  public:
    Framer(const BackgroundSight& sight, const kiosk::Comfort& comfort)
        : sight_(sight),
          shape_(screens::shape_of(sight.width_px, sight.height_px)),
          u_(double{screens::px_per_u_of(sight.width_px, sight.height_px)}),
          half_(0.5 * sight.width_px, 0.5 * sight.height_px),
          ledge_px_(double{screens::ledge_y(shape_, static_cast<float>(sight.height_px / u_), comfort)} *
                    u_) {}

    // Pixels from the picture's middle, without shift and zoom.
    [[nodiscard]] std::optional<dvec2> from_middle(View view, const dvec3& place_mm) const {
        const auto seen = sight_.project(view, {}, place_mm);
        if (!seen) return std::nullopt;
        return *seen - half_;
    }

    [[nodiscard]] Framing throwing(double pot_mm, bool reach) const {
        const auto head = from_middle(View::kThrowing, {0.0, -kHeadEdgeMm, kHeadRadiusMm});
        const auto foot = from_middle(View::kThrowing, {0.0, 0.0, kFootMm});
        const auto top = from_middle(View::kThrowing, {0.0, pot_mm + kHandMm, -kFootMm});
        const auto low_top = from_middle(View::kThrowing, {0.0, kLeastFitMm + kHandMm, -kFootMm});
        if (!head || !foot || !top || !low_top) return {};
        const bool tall = shape_ == Shape::kTall;
        Framing framing{.zoom = reach ? (tall ? 0.74 : 0.82) : 1.0};
        const double top_px = (reach ? kReachTopU + (tall ? 180.0 : 0.0) : kTopU) * u_;
        const double low_px = ledge_px_ - kAirU * u_;
        // The head's front edge should be above the ledge; the pot's foot and rim have priority.
        const auto shift_y = [&](double from_px, double to_px) {
            return shift_for(from_px, to_px, framing.zoom, half_.y);
        };
        const double room = low_px - top_px;
        framing.zoom = std::min(framing.zoom, std::max(kHeadZoom, room / (head->y - low_top->y)));
        const double needs = foot->y - top->y;
        if (needs * framing.zoom > room) framing.zoom = std::max(kLeastZoom, room / needs);
        const double by_head = shift_y(head->y, low_px);
        const double by_top = shift_y(top->y, top_px);
        const double by_foot = shift_y(foot->y, low_px);
        const double lower = reach ? kLowerU * u_ / half_.y : 0.0;
        framing.shift.y = std::min(std::max(by_head + lower, by_top), by_foot);
        // Not below the background's picture, unless the pot needs the room.
        if (!reach) framing.shift.y = std::min(framing.shift.y, std::max(framing.zoom - 1.0, by_top));
        // Makes room for the hand's keys.
        if (reach && tall) framing.shift.x = -0.3;
        if (reach && shape_ == Shape::kSquare) framing.shift.x = -0.15;
        return framing;
    }

    // Closer, because a brush is small; the pot is centred above the ledge.
    [[nodiscard]] Framing decorating(double pot_mm) const {
        constexpr double kNearest = 1.39;
        constexpr double kFootU = 44.0;
        const auto foot = from_middle(View::kThrowing, {0.0, 0.0, kFootMm});
        const auto top = from_middle(View::kThrowing, {0.0, pot_mm, -kFootMm});
        if (!foot || !top) return {};
        const double top_px = kTopU * u_;
        const double low_px = ledge_px_ - kFootU * u_;
        Framing framing;
        framing.zoom = std::clamp((low_px - top_px) / (foot->y - top->y), kLeastZoom, kNearest);
        const double middle = 0.5 * (foot->y + top->y);
        // Within the background's picture.
        const double most = std::max(0.0, framing.zoom - 1.0);
        framing.shift.y =
            std::clamp(shift_for(middle, 0.5 * (top_px + low_px), framing.zoom, half_.y), -most, most);
        return framing;
    }

    [[nodiscard]] Framing looking_in(double pot_mm) const {
        const auto middle = from_middle(View::kLookingIn, {0.0, 0.5 * pot_mm, 0.0});
        if (!middle) return {};
        return {.shift = {0.0, shift_for(middle->y, 0.5 * (kTopU * u_ + ledge_px_), 1.0, half_.y)}};
    }

    // The box of attract mode: right of the words, or above them.
    [[nodiscard]] Framing attracting() const {
        const auto foot = from_middle(View::kThrowing, {0.0, 0.0, kFootMm});
        if (!foot) return {};
        Framing framing;
        double foot_u = 560.0;
        if (shape_ == Shape::kWide) {
            framing.zoom = 1.12;
            framing.shift.x = 165.0 / 640.0;
        } else if (shape_ == Shape::kTall) {
            foot_u = 800.0;
        } else {
            foot_u = 520.0;
        }
        framing.shift.y = shift_for(foot->y, foot_u * u_, framing.zoom, half_.y);
        // The words' scrim hides the background's lower end; nothing hides its upper end.
        framing.shift.y = std::min(framing.shift.y, framing.zoom - 1.0);
        return framing;
    }

  private:
    const BackgroundSight& sight_;
    Shape shape_;
    double u_;
    dvec2 half_;
    double ledge_px_;
};

}  // namespace

CameraRequest KioskCamera::request(const kiosk::State& state, bool shows_room, double pot_mm,
                                   const BackgroundSight& sight) {
    CameraRequest request;
    const Framer framer(sight, state.comfort);
    const visit::Step& step = visit::step_of(state.screen);
    if (step.camera == visit::Camera::kAttract) {
        fitted_mm_ = 0.0;
        request.framing = framer.attracting();
        request.sways = shows_room && !state.comfort.still;
        return request;
    }
    // A pot that sinks a little keeps its framing.
    if (pot_mm > fitted_mm_ || pot_mm < fitted_mm_ - 2.5 * kFitStepMm)
        fitted_mm_ = std::max(kLeastFitMm, kFitStepMm * std::ceil(pot_mm / kFitStepMm));
    if (step.finger == visit::Finger::kClay && state.throwing.looks_in) {
        request.view = View::kLookingIn;
        request.framing = framer.looking_in(fitted_mm_);
        return request;
    }
    if (step.camera == visit::Camera::kNear && !state.comfort.reach) {
        request.framing = framer.decorating(fitted_mm_);
        return request;
    }
    const bool is_low = step.camera != visit::Camera::kFar && state.comfort.reach;
    request.framing = framer.throwing(fitted_mm_, is_low);
    return request;
}

double evening_at(const kiosk::Config& config, int minute_of_day) {
    constexpr int kDayMin = 24 * 60;
    constexpr int kDuskMin = 60;
    constexpr double kSteps = 12.0;
    if (config.hours.opens_min == config.hours.closes_min) return 0.0;
    if (!kiosk::is_open(config, minute_of_day)) return 1.0;
    const int left = (config.hours.closes_min - minute_of_day + kDayMin) % kDayMin;
    if (left >= kDuskMin) return 0.0;
    return std::floor(kSteps * (1.0 - static_cast<double>(left) / kDuskMin)) / kSteps;
}

SceneEdges scene_edges(const Framing& framing, int width_px, int height_px) {
    const dvec2 half(0.5 * width_px, 0.5 * height_px);
    return {.left = half.x * (1.0 + framing.shift.x - framing.zoom),
            .top = half.y * (1.0 + framing.shift.y - framing.zoom),
            .right = half.x * (1.0 + framing.shift.x + framing.zoom)};
}

}  // namespace onggi::app

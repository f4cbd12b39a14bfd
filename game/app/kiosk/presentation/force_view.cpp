#include "game/app/kiosk/presentation/force_view.h"

#include <algorithm>
#include <cmath>

#include "game/wheel/hands.h"

namespace onggi::app {
namespace {

constexpr double kFollowS = 0.04;
constexpr double kRescaleS = 0.2;
constexpr double kLeastShown = 0.03;  // fraction of a full arrow
constexpr int kMostLines = 12;
constexpr int kBeltPoints = 48;

struct Ring {
    double outer_mm = 0.0;
    double inner_mm = 0.0;
    double low_mm = 0.0;
    double high_mm = 0.0;
};

Ring ring_of(const pot::Pot& shape, int place) {
    const auto at = static_cast<std::size_t>(place);
    const auto& tops = shape.top_mm;
    Ring ring{.outer_mm = double{shape.outer_mm[at]}};
    if (tops.empty()) {
        const double pitch_mm = shape.height_mm / shape.ring_count();
        ring.low_mm = place * pitch_mm;
        ring.high_mm = ring.low_mm + pitch_mm;
        return ring;
    }
    ring.inner_mm = double{shape.inner_mm[at]};
    ring.low_mm = place == 0 ? 0.0 : double{tops[at - 1]};
    ring.high_mm = double{tops[at]};
    return ring;
}

// The half of a circle that faces the camera, from left to right; or the whole circle.
std::vector<vec2> circle(const Sight& sight, double radius_mm, double y_mm, bool whole) {
    const dvec3 eye = sight.towards_eye({0.0, y_mm, 0.0});
    const double flat = std::sqrt(eye.x * eye.x + eye.z * eye.z);
    const dvec2 front = flat > 0.0 ? dvec2(eye.x, eye.z) / flat : dvec2(0.0, 1.0);
    const dvec2 right(front.y, -front.x);
    std::vector<vec2> line;
    for (int i = 0; i <= kBeltPoints; ++i) {
        const double fraction = static_cast<double>(i) / kBeltPoints;
        const double angle = kPi * (whole ? 2.0 * fraction : 1.0 - fraction);
        const dvec2 at = radius_mm * (std::cos(angle) * right + std::sin(angle) * front);
        const auto px = sight.project({at.x, y_mm, at.y});
        if (!px) return {};
        line.emplace_back(*px);
    }
    return line;
}

void add_rings(screens::ForceTouch& touch, const pot::Pot& shape, const RingSpan& span, bool inside,
               const Sight& sight) {
    if (span.size() <= 0) return;
    const auto line = [&](int place, double y_mm) {
        const Ring ring = ring_of(shape, place);
        return circle(sight, inside ? ring.inner_mm : ring.outer_mm, y_mm, inside);
    };
    const int lines = std::min(span.size(), kMostLines);
    for (int k = 0; k < lines; ++k) {
        const int place = span.first + static_cast<int>((k + 0.5) * span.size() / lines);
        const Ring ring = ring_of(shape, place);
        touch.rings_px.push_back(line(place, 0.5 * (ring.low_mm + ring.high_mm)));
    }
    if (inside) return;
    touch.upper_px = line(span.end - 1, ring_of(shape, span.end - 1).high_mm);
    touch.lower_px = line(span.first, ring_of(shape, span.first).low_mm);
}

screens::ForceArrow arrow_of(const dvec3& from_mm, const dvec3& force_n, double mm_per_n,
                             const Sight& sight) {
    screens::ForceArrow arrow;
    const double size_n = glm::length(force_n);
    const dvec3 to_mm = from_mm + mm_per_n * force_n;
    const auto from = sight.project(from_mm);
    const auto to = sight.project(to_mm);
    if (!from || !to || size_n * mm_per_n < kLeastShown * ForceView::kFullArrowMm) return arrow;
    const double into = glm::dot(force_n / size_n, sight.towards_eye(from_mm));
    arrow.from_px = vec2(*from);
    arrow.to_px = vec2(*to);
    arrow.seen = static_cast<float>(std::sqrt(std::max(0.0, 1.0 - into * into)));
    arrow.towards = into > 0.0;
    arrow.shown = true;
    return arrow;
}

}  // namespace

Sight sight_of(const wheel::LiveView& view) {
    return {.project = [&view](const dvec3& place_mm) { return view.project(place_mm); },
            .towards_eye = [&view](const dvec3& place_mm) { return view.towards_eye(place_mm); }};
}

Forces forces_of(const clay::ContactForces& forces) {
    return {forces.stiffness_n, forces.viscosity_n, forces.friction_n, forces.total_n()};
}

dvec3 touched_mm(const dvec3& tool_mm, double radius_mm, const dvec3& stiffness_n) {
    const double size_n = glm::length(stiffness_n);
    return size_n > 0.0 ? tool_mm - stiffness_n * (radius_mm / size_n) : tool_mm;
}

RingSpan rings_touched(const pot::Pot& shape, const clay::ContactForces& forces) {
    if (forces.contacts == 0) return {};
    const auto middle_mm = [&](int place) {
        const Ring ring = ring_of(shape, place);
        return 0.5 * (ring.low_mm + ring.high_mm);
    };
    // The first ring whose middle is above a height.
    const auto first_above = [&](double y_mm) {
        int first = 0;
        int end = shape.ring_count();
        while (first < end) {
            const int middle = first + (end - first) / 2;
            if (middle_mm(middle) > y_mm) {
                end = middle;
            } else {
                first = middle + 1;
            }
        }
        return first;
    };
    return {first_above(forces.contact_low_mm), first_above(forces.contact_high_mm)};
}

void ForceView::look(const haptic::Snapshot& snapshot, double now_s) {
    const double dt_s = std::clamp(now_s - last_s_, 0.0, 0.1);
    last_s_ = now_s;
    const std::array<const clay::ContactForces*, 2> hands{&snapshot.result.forces,
                                                          &snapshot.result.second_forces};
    for (std::size_t hand = 0; hand < hands.size(); ++hand) {
        const Forces now_n = forces_of(*hands[hand]);
        for (std::size_t k = 0; k < now_n.size(); ++k) {
            dvec3& shown = shown_n_[hand][k];
            // A force that has ended disappears at once.
            shown = hands[hand]->contacts == 0 ? dvec3(0.0)
                                               : shown + (now_n[k] - shown) * (dt_s / (dt_s + kFollowS));
        }
    }
    trace_.add(now_s, glm::length(hands[0]->total_n()), snapshot.periods);
    full_n_ += (trace_.full_n() - full_n_) * std::min(1.0, dt_s / kRescaleS);
    // Sudden forces, and the other hand's, must not exceed an arrow's length.
    for (const Forces& shown_n : shown_n_)
        for (const dvec3& force_n : shown_n)
            full_n_ = std::max(full_n_, glm::length(force_n));
}

screens::ForceFrame ForceView::frame(const haptic::Snapshot& snapshot, const Sight& sight,
                                     bool with_sum) const {
    screens::ForceFrame frame{.trace = &trace_, .with_sum = with_sum};
    for (std::size_t k = 0; k < screens::kForceCount; ++k)
        frame.size_n[k] = glm::length(shown_n_[0][k]);
    const auto add_touch = [&](std::size_t hand, const clay::ContactForces& forces,
                               const wheel::DrawnHand& drawn) {
        if (forces.contacts == 0) return;
        screens::ForceTouch touch;
        touch.is_beside = drawn.side != tool::Side::kTop;
        const dvec3 at_mm = touched_mm(drawn.position_mm, drawn.radius_mm,
                                       shown_n_[hand][static_cast<std::size_t>(screens::Force::kStiffness)]);
        for (std::size_t k = 0; k < screens::kForceCount; ++k)
            touch.arrows[k] = arrow_of(at_mm, shown_n_[hand][k], mm_per_n(), sight);
        add_rings(touch, *snapshot.pot, rings_touched(*snapshot.pot, forces), drawn.side == tool::Side::kIn,
                  sight);
        frame.touches.push_back(std::move(touch));
    };
    const std::array<wheel::DrawnHand, 2> hands = wheel::hands_of(snapshot);
    add_touch(0, snapshot.result.forces, hands[0]);
    add_touch(1, snapshot.result.second_forces, hands[1]);
    return frame;
}

}  // namespace onggi::app

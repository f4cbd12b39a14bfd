// The studio clay's state as bytes and as a hash.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "game/clay/state_numbers.h"
#include "game/clay/studio/rings.h"
#include "game/clay/studio/roundness.h"
#include "game/clay/studio/studio_clay.h"

namespace onggi::clay {
namespace {

using studio::Rings;

// The start state begins with one of these tags and the lump, which determine its size.
constexpr std::uint32_t kStateTag = 0x334c4353;  // "SCL3"
constexpr std::uint32_t kPairTag = 0x344c4353;   // "SCL4": while a second finger presses
constexpr std::size_t kHeadBytes = 4 + 8 + 4 + 8 + 4 + 4 + 8 + 4;

template <typename Visitor, typename Lump>
void visit_lump(Visitor& visitor, Lump& lump) {
    visit(visitor, lump.mass_g, lump.body, lump.liquidity_index, lump.rings, lump.sectors,
          lump.off_centre_mm);
}

// Visits the used points of the trail, oldest first; a second finger only while it presses, which a reader
// must know before.
template <typename Visitor, typename Grip>
void visit_grip(Visitor& visitor, Grip& grip) {
    visit(visitor, grip.presses);
    if (!grip.presses) return;
    visit(visitor, grip.grip, grip.guard, grip.shown_guard, grip.is_spent, grip.pulls, grip.opens_by_itself,
          grip.finger_mm, grip.hand_mm, grip.landed_mm, grip.side, grip.landed_top_mm, grip.offset_mm,
          grip.offset_way_mm, grip.travel_mm, grip.heading, grip.still_s, grip.rests_mm, grip.wants_s,
          grip.pulled_mm, grip.sunk_mm, grip.bottom_mm, grip.bore_mm, grip.press_mm, grip.bears_n_mm,
          grip.low_mm, grip.high_mm, grip.credit_s);
    for (auto& radius : grip.landed_outer_mm)
        visit(visitor, radius);
    visit(visitor, grip.stage);
    int count = grip.trail.count;
    visit(visitor, count);
    const int points = std::clamp(count, 0, studio::GripTrail::kMost);
    if constexpr (!std::is_const_v<Grip>) {
        grip.trail.first = 0;
        grip.trail.count = count;
    }
    for (int i = 0; i < points; ++i) {
        const int place = (grip.trail.first + i) % studio::GripTrail::kMost;
        visit(visitor, grip.trail.point_mm[static_cast<std::size_t>(place)]);
    }
    auto& second = grip.second;
    if (second.presses) visit(visitor, second.is_inside, second.offset_mm, second.between_mm);
}

bool is_between(double value, double least, double most) {
    return value >= least && value <= most;
}

bool is_sound(const studio::GripState& grip) {
    constexpr double kFarMm = 1e4;
    const auto is_near = [](double value) { return is_between(value, -kFarMm, kFarMm); };
    const auto is_place = [&](const dvec2& place) { return is_near(place.x) && is_near(place.y); };
    const auto is_number = [&](double value) { return is_between(value, -1e7, 1e7); };
    const studio::GripTrail& trail = grip.trail;
    const auto points =
        std::span(trail.point_mm)
            .first(static_cast<std::size_t>(std::clamp(trail.count, 0, studio::GripTrail::kMost)));
    return is_between(static_cast<int>(grip.grip), 0, static_cast<int>(studio::Grip::kRim)) &&
           is_between(static_cast<int>(grip.guard), 0, static_cast<int>(studio::GripGuard::kAsHigh)) &&
           is_between(static_cast<int>(grip.shown_guard), 0, static_cast<int>(studio::GripGuard::kAsHigh)) &&
           is_place(grip.finger_mm) && is_place(grip.hand_mm) && is_place(grip.landed_mm) &&
           std::fabs(grip.side) == 1.0 && is_near(grip.landed_top_mm) && is_near(grip.offset_mm) &&
           is_between(grip.offset_way_mm, 1.0, 1e7) && is_number(grip.travel_mm) &&
           is_between(grip.heading, -2.0, 2.0) && is_number(grip.still_s) && is_near(grip.rests_mm) &&
           is_number(grip.wants_s) && is_near(grip.pulled_mm) && is_near(grip.sunk_mm) &&
           is_near(grip.bottom_mm) && is_near(grip.bore_mm) && is_near(grip.press_mm) &&
           is_between(grip.bears_n_mm, 0.0, 1e12) && is_near(grip.low_mm) && is_near(grip.high_mm) &&
           is_between(grip.credit_s, 0.0, 1.0) && is_between(grip.stage, 0, studio::kGripStages - 1) &&
           is_between(trail.count, 0, studio::GripTrail::kMost) && is_near(grip.second.offset_mm) &&
           is_near(grip.second.between_mm) && (grip.presses || !grip.second.presses) &&
           std::all_of(points.begin(), points.end(), is_place) &&
           std::all_of(grip.landed_outer_mm.begin(), grip.landed_outer_mm.end(),
                       [&](float radius) { return is_between(static_cast<double>(radius), 0.0, 1e3); });
}

}  // namespace

template <typename Self, typename Visitor>
void StudioClay::visit_state(Self& self, Visitor& visitor) {
    auto& rings = self.rings_;
    const auto count = static_cast<std::size_t>(rings.count);
    for (auto* column : {&rings.volume_mm3, &rings.outer_mm, &rings.inner_mm})
        visitor.numbers(std::span(column->data(), count));
    for (auto* column : {&rings.centre_x_mm, &rings.centre_z_mm, &rings.rough_mm, &rings.liquidity,
                         &rings.film, &rings.strength_kpa, &rings.load_index, &rings.shear, &rings.slump_rate,
                         &rings.slump_above, &rings.slump_axial, &rings.slump_hoop})
        visitor.numbers(std::span(column->data(), count));
    for (int i = 0; i < rings.count; ++i) {
        if (rings.rough_mm[Rings::at(i)] > 0.0F)
            visitor.numbers(std::span(rings.row_of(i), static_cast<std::size_t>(rings.sectors)));
    }
    visit(visitor, self.ledger_.lump_mm3, self.ledger_.trimmings_mm3, self.ledger_.slip_mm3);

    auto& sweep = self.sweep_;
    auto& failure = sweep.failure;
    visit(visitor, sweep.goes_up, sweep.next, sweep.credit, sweep.round, sweep.above.volume_mm3,
          sweep.above.volume_radius_mm4, sweep.running, sweep.last_hollow, sweep.slumps, sweep.peak_index,
          sweep.peak_height_mm, sweep.peak_cause, sweep.growing_peak, sweep.growing_height_mm,
          sweep.growing_cause, failure.cause, failure.height_mm, failure.radius_mm, failure.load_index,
          failure.stress_kpa, failure.strength_kpa, failure.wheel_speed_rad_s, failure.torn);
    for (auto& hand : self.hands_)
        visit(visitor, hand.side, hand.direction, hand.has_mean, hand.mean_distance_mm, hand.wobble_mm,
              hand.previous_position_mm, hand.has_previous, hand.has_slow_height, hand.slow_height_mm);
    visit_grip(visitor, self.grip_);
    auto& carried = self.carried_;
    visit(visitor, carried.film, carried.tend_credit, carried.change_credit, carried.wheel_load_n_mm,
          carried.load_height_mm, carried.tend_next, carried.stripe, carried.owes_cursors, carried.cut_off,
          carried.wire_was_used, carried.splits, carried.joins);
}

std::uint64_t StudioClay::state_hash() const {
    StateHasher hash;
    const Rotation heading = wheel_.heading();
    const double speed = wheel_.speed_rad_s();
    visit(hash, rings_.count, heading.cosine, heading.sine, speed);
    visit_state(*this, hash);
    return hash.value();
}

std::vector<std::byte> StudioClay::start_state() const {
    StateWriter out;
    const Rotation heading = wheel_.heading();
    const double speed = wheel_.speed_rad_s();
    visit(out, grip_.second.presses ? kPairTag : kStateTag);
    visit_lump(out, lump_);
    visit(out, rings_.count, heading.cosine, heading.sine, speed);
    visit_state(*this, out);
    return out.take();
}

Result<StudioClay> StudioClay::from_start_state(std::span<const std::byte> bytes) {
    const auto damaged = [](std::string_view found) {
        return bad_input(fmt::format("studio clay start state, {}", found));
    };
    if (bytes.size() < kHeadBytes)
        return damaged(fmt::format("size: expected at least {} bytes, found {}", kHeadBytes, bytes.size()));
    StateReader in(bytes);
    std::uint32_t tag = 0;
    visit(in, tag);
    if (tag != kStateTag && tag != kPairTag)
        return damaged(
            fmt::format("tag: expected {:#010x} or {:#010x}, found {:#010x}", kStateTag, kPairTag, tag));
    StudioLump lump;
    visit_lump(in, lump);
    if (const auto checked = check(lump); !checked) return damaged(checked.error().message);
    int count = 0;
    visit(in, count);
    if (count < 0 || count > studio::ring_capacity(lump))
        return damaged(fmt::format("rings: expected 0 to {}, found {}", studio::ring_capacity(lump), count));

    StudioClay clay(lump);
    clay.rings_.reset(count);
    clay.grip_.second.presses = tag == kPairTag;
    Rotation heading;
    double speed = 0.0;
    visit(in, heading.cosine, heading.sine, speed);
    visit_state(clay, in);
    if (in.is_short() || in.left() != 0)
        return damaged(fmt::format("size: expected {} {} bytes for {} rings",
                                   in.is_short() ? "more than" : "exactly",
                                   in.is_short() ? bytes.size() : bytes.size() - in.left(), count));
    const double length2 = heading.cosine * heading.cosine + heading.sine * heading.sine;
    if (!(std::fabs(length2 - 1.0) < 1e-9)) return damaged("wheel angle: expected a unit vector");
    if (!is_between(speed, 0.0, studio::kFastestWheelRadS))
        return damaged(fmt::format("wheel speed: expected 0 to {:.4g} rad/s, found {}",
                                   studio::kFastestWheelRadS, speed));
    clay.wheel_ = studio::PoweredWheel(heading, speed);
    if (const auto flag = in.strange()) return damaged(fmt::format("flag: expected 0 or 1, found {}", *flag));
    if (const std::string damage = damage_of(clay); !damage.empty()) return damaged(damage);
    clay.rings_.find_floor();
    clay.rings_.settle(0, count);
    if (!std::isfinite(clay.height_mm())) return damaged("height: expected a finite number");
    return clay;
}

// Returns the fault of a state that no tick could have left; empty if the state is sound. Heights and places
// are not checked: they are computed later.
std::string StudioClay::damage_of(const StudioClay& clay) {
    const Rings& rings = clay.rings_;
    for (int i = 0; i < rings.count; ++i) {
        const std::size_t at = Rings::at(i);
        if (!studio::is_on_grid(rings.volume_mm3[at]) || !(rings.volume_mm3[at] > 0.0))
            return fmt::format("volume of ring {}: expected whole grains above zero, found {}", i,
                               rings.volume_mm3[at]);
        if (!(rings.inner_mm[at] >= 0.0 && rings.outer_mm[at] - rings.inner_mm[at] > 1e-3 &&
              rings.outer_mm[at] <= studio::kWidestMm))
            return fmt::format("radii of ring {}: expected 0 <= inner < outer <= {} mm, found {} and {}", i,
                               studio::kWidestMm, rings.inner_mm[at], rings.outer_mm[at]);
        const auto in = [&](const std::vector<float>& column, double least, double most) {
            return is_between(static_cast<double>(column[at]), least, most);
        };
        const bool sound = in(rings.centre_x_mm, -10.0, 10.0) && in(rings.centre_z_mm, -10.0, 10.0) &&
                           in(rings.rough_mm, 0.0, 1000.0) && in(rings.liquidity, -1.0, 2.0) &&
                           in(rings.film, 0.0, 1.0) && in(rings.strength_kpa, 1e-3, 1e5) &&
                           in(rings.load_index, 0.0, 1e9) && in(rings.shear, 0.0, 1e3) &&
                           in(rings.slump_rate, 0.0, 1e3) && in(rings.slump_above, 0.0, 1e3) &&
                           in(rings.slump_axial, -10.0, 10.0) && in(rings.slump_hoop, -10.0, 10.0);
        if (!sound) return fmt::format("ring {}: expected numbers within their bounds", i);
        if (rings.rough_mm[at] > 0.0F) {
            for (int s = 0; s < rings.sectors; ++s) {
                if (!is_between(static_cast<double>(rings.row_of(i)[s]), -1000.0, 1000.0))
                    return fmt::format("residual of ring {}, sector {}: expected within 1000 mm", i, s);
            }
        }
    }
    const studio::Ledger& ledger = clay.ledger_;
    for (const double volume : {ledger.lump_mm3, ledger.trimmings_mm3, ledger.slip_mm3}) {
        if (!studio::is_on_grid(volume))
            return fmt::format("ledger: expected whole grains, found {}", volume);
    }
    if (clay.ledger_error_mm3() != 0.0)
        return fmt::format("ledger: expected an error of 0, found {} mm^3", clay.ledger_error_mm3());

    const studio::LoadSweep& sweep = clay.sweep_;
    const auto is_cause = [](studio::Cause cause) {
        return is_between(static_cast<int>(cause), 0, static_cast<int>(studio::Cause::kTwist));
    };
    const int most = rings.count;
    // Going down, the cursor always has a next ring; going up, the last ring may just have been visited.
    if (!is_between(sweep.next, sweep.goes_up || most == 0 ? 0 : 1, most) ||
        !is_between(sweep.credit, 0.0, 1e6) || !is_between(static_cast<double>(sweep.running), 0.0, 1e3) ||
        !is_cause(sweep.peak_cause) || !is_cause(sweep.growing_cause) || !is_cause(sweep.failure.cause) ||
        !is_between(sweep.above.volume_mm3, 0.0, 1e12) ||
        !is_between(sweep.above.volume_radius_mm4, 0.0, 1e15) || !is_between(sweep.peak_index, 0.0, 1e9) ||
        !is_between(sweep.growing_peak, 0.0, 1e9))
        return "load cursor: expected numbers within their bounds";
    for (const studio::Hand& hand : clay.hands_) {
        const double length2 = hand.direction.x * hand.direction.x + hand.direction.y * hand.direction.y;
        const bool sound =
            is_between(static_cast<int>(hand.side), 0, static_cast<int>(studio::Side::kTop)) &&
            std::fabs(length2 - 1.0) < 1e-9 && std::isfinite(hand.mean_distance_mm) &&
            is_between(hand.wobble_mm.x, -10.0, 10.0) && is_between(hand.wobble_mm.y, -10.0, 10.0) &&
            std::isfinite(hand.previous_position_mm.x) && std::isfinite(hand.previous_position_mm.y) &&
            std::isfinite(hand.previous_position_mm.z) && std::isfinite(hand.slow_height_mm);
        if (!sound) return "hand: expected a known side, a unit direction and finite numbers";
    }
    if (!is_sound(clay.grip_)) return "grip: expected numbers within their bounds";
    if (!is_between(clay.carried_.film, 0.0, 1.0) || !is_between(clay.carried_.tend_credit, 0.0, 1e6) ||
        !is_between(clay.carried_.change_credit, 0.0, 1e6) ||
        !is_between(clay.carried_.wheel_load_n_mm, 0.0, 1e9) ||
        !std::isfinite(clay.carried_.load_height_mm) ||
        !is_between(clay.carried_.tend_next, 0, rings.capacity + 2) ||
        !is_between(clay.carried_.stripe, 0, studio::kMostStripes - 1))
        return "cursor: expected numbers within their bounds";
    return {};
}

}  // namespace onggi::clay

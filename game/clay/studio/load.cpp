#include "game/clay/studio/load.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/math/wide_vectors.h"
#include "game/clay/studio/roundness.h"
#include "game/clay/studio/strength.h"
#include "game/clay/studio/wall_field.h"

namespace onggi::clay::studio {
namespace {

// Density times gravity, and density times (rad/s)^2 mm^2, both in kPa: 1e-6 from g/mm^3 mm^2/s^2 to N/mm^2.
constexpr double kWeightKpaPerMm = kDensityGPerMm3 * kGravityMmS2 * 1e-6 * kKpaPerNMm2;
constexpr double kSpinKpa = kDensityGPerMm3 * 1e-6 * kKpaPerNMm2;
constexpr double kSolidDisc = 0.41;  // ratio of the hoop stress in a spinning disc to a thin ring's
constexpr double kShell = 0.5;

// Strain rate of overloaded clay, and the length of wall that goes with it.
constexpr double kSlumpS = 0.3;
constexpr double kFastestSlump = 1.0;  // 1/s
constexpr double kShortestSlumpMm = 2.0;
constexpr double kLeastKpa = 1e-9;    // a smaller stress has no direction
constexpr double kTornAtShear = 1.0;  // rad: a vertical line on the wall lies at 45 degrees

// Strength and water change slowly: each ring is refreshed once in this many rounds.
constexpr std::uint64_t kRefreshRounds = 16;

double slump_length(const Rings& rings, int i) {
    const double mean = 0.5 * (rings.outer_mm[at(i)] + rings.inner_mm[at(i)]);
    return std::max(0.5 * std::sqrt(mean * rings.wall_mm(i)), kShortestSlumpMm);
}

// Takes the rate of ring i into the running average.
void average_in(LoadSweep& sweep, const Rings& rings, int i, double rate) {
    const double q = rings.height_mm[at(i)] / slump_length(rings, i);
    sweep.running = static_cast<float>((static_cast<double>(sweep.running) + 0.5 * q * rate) / (1.0 + q));
}

}  // namespace

Cause Stress::cause() const {
    const double spin = std::fabs(spin_kpa);
    const double twist = std::sqrt(3.0) * std::fabs(twist_kpa);
    const double weight = std::fabs(weight_kpa);
    const double overhang = std::max(std::fabs(bending_kpa), std::fabs(slope_kpa));
    const double most = std::max({spin, twist, weight, overhang});
    if (!(most > 0.0)) return Cause::kNone;
    return most == spin       ? Cause::kSpin
           : most == twist    ? Cause::kTwist
           : most == overhang ? Cause::kOverhang
                              : Cause::kWeight;
}

namespace {

// A ring as its stress depends on it; the slope is that of its wall.
struct RingShape {
    double outer_mm;
    double inner_mm;
    double volume_mm3;
    double slope;
};

// Branch-free, so that a loop over rings vectorises.
[[gnu::always_inline]] inline Stress stress_of(const RingShape& ring, const Above& above, double wheel_speed,
                                               double twist) {
    const double ro = ring.outer_mm;
    const double ri = ring.inner_mm;
    const bool hollow = ri > 0.0;
    const double wall = ro - ri;
    const double mean = 0.5 * (ro + ri);
    const double area = kPi * wall * (ro + ri);
    const double slope = ring.slope;
    const double along = wall / std::sqrt(1.0 + slope * slope);  // tn
    const double overhang =
        above.volume_mm3 > 0.0 ? 2.0 * std::fabs(above.volume_radius_mm4 / above.volume_mm3 - mean) : 0.0;
    const double shell = kShell * mean * along * std::fabs(slope);
    const double square = overhang * overhang;
    const double held = square + shell > 0.0 ? square * shell / (square + shell) : 0.0;  // Le^2

    Stress stress;
    stress.weight_kpa = -kWeightKpaPerMm * (above.volume_mm3 + 0.5 * ring.volume_mm3) / area;
    stress.spin_kpa = kSpinKpa * wheel_speed * wheel_speed * ro * ro * (hollow ? 1.0 : kSolidDisc);
    stress.slope_kpa = hollow ? kWeightKpaPerMm * mean * slope : 0.0;
    stress.bending_kpa = hollow ? 3.0 * kWeightKpaPerMm * held / along : 0.0;
    stress.twist_kpa = (hollow ? kKpaPerNMm2 * twist : kKpaPerNMm2 * 2.0 * twist) /
                       (hollow ? kTurn * mean * mean * wall : kPi * ro * ro * ro);
    return stress;
}

}  // namespace

Stress stress_in(const Rings& rings, int i, const Above& above, double wheel_speed, double twist) noexcept {
    const RingShape ring{rings.outer_mm[at(i)], rings.inner_mm[at(i)], rings.volume_mm3[at(i)],
                         rings.is_hollow(i) ? wall_slope(rings, i) : 0.0};
    return stress_of(ring, above, wheel_speed, twist);
}

namespace {

// The rings [first, first + count) of one step of the way down. Entry k is ring first + k.
struct Step {
    static constexpr int kMost = 64;
    using Column = std::array<double, kMost>;

    int first = 0;
    int count = 0;
    Column volume_above, volume_radius_above, slope, centre, twist, index;
    std::array<double, kMost + 2 * kSlopeRings> seen_centre;  // entry k is ring first - kSlopeRings + k

    [[nodiscard]] Stress stress(const Rings& rings, int k, double wheel_speed) const {
        const std::size_t i = at(first + k);
        return stress_of({rings.outer_mm[i], rings.inner_mm[i], rings.volume_mm3[i], slope[at(k)]},
                         {volume_above[at(k)], volume_radius_above[at(k)]}, wheel_speed, twist[at(k)]);
    }
};

// The heights, the slopes and the twist of the step's rings, and the clay above each.
void measure(Step& step, LoadSweep& sweep, const Rings& rings, const LoadInput& input) {
    const int first = step.first;
    const int end = first + step.count;
    for (int k = step.count - 1; k >= 0; --k) {
        const std::size_t i = at(first + k);
        step.volume_above[at(k)] = sweep.above.volume_mm3;
        step.volume_radius_above[at(k)] = sweep.above.volume_radius_mm4;
        const double mean = rings.inner_mm[i] > 0.0 ? 0.5 * (rings.outer_mm[i] + rings.inner_mm[i]) : 0.0;
        sweep.above.volume_mm3 += rings.volume_mm3[i];
        sweep.above.volume_radius_mm4 += rings.volume_mm3[i] * mean;
    }
    const Rings::Range seen{std::max(first - kSlopeRings, 0), std::min(end + kSlopeRings, rings.count)};
    double* const seen_centre = step.seen_centre.data() + kSlopeRings - first;
    rings.centres(seen, seen_centre + seen.first);
    // Between these two bounds a hollow ring has all its neighbours for the slope.
    const int inner_first = std::min(std::max(first, rings.first_hollow + kSlopeRings), end);
    const int inner_end = std::max(std::min(end, rings.count - kSlopeRings), inner_first);
    const auto slope_of = [&](int i) { return rings.is_hollow(i) ? wall_slope(rings, i) : 0.0; };
    for (int i = first; i < inner_first; ++i)
        step.slope[at(i - first)] = slope_of(i);
    slopes_between(rings, {inner_first, inner_end}, seen_centre, step.slope.data() + (inner_first - first));
    for (int i = inner_end; i < end; ++i)
        step.slope[at(i - first)] = slope_of(i);
    for (int k = 0; k < step.count; ++k) {
        step.centre[at(k)] = seen_centre[first + k];
        step.twist[at(k)] = step.centre[at(k)] < input.twist_height_mm ? input.twist_n_mm : 0.0;
    }
}

// The load indices of the step's rings and the ways in which they would slump.
[[gnu::always_inline]] inline void weigh_each(
    const double* __restrict__ outer, const double* __restrict__ inner, const double* __restrict__ volume,
    const float* __restrict__ strength, const double* __restrict__ volume_above,
    const double* __restrict__ volume_radius_above, const double* __restrict__ slope,
    const double* __restrict__ twist, double* __restrict__ index, float* __restrict__ load_index,
    float* __restrict__ slump_axial, float* __restrict__ slump_hoop, int n, double wheel_speed) {
    for (int k = 0; k < n; ++k) {
        const Stress stress = stress_of({outer[k], inner[k], volume[k], slope[k]},
                                        {volume_above[k], volume_radius_above[k]}, wheel_speed, twist[k]);
        const double equivalent = stress.equivalent_kpa();
        const double least = equivalent < kLeastKpa ? kLeastKpa : equivalent;
        index[k] = equivalent / (2.0 * static_cast<double>(strength[k]));
        load_index[k] = static_cast<float>(index[k]);
        // Levy-Mises: plastic strain is proportional to the stress deviator.
        const double mean = (stress.axial_kpa() + stress.hoop_kpa()) / 3.0;
        slump_axial[k] = static_cast<float>(1.5 * (stress.axial_kpa() - mean) / least);
        slump_hoop[k] = static_cast<float>(1.5 * (stress.hoop_kpa() - mean) / least);
    }
}

ONGGI_WIDE_VECTORS void weigh_all(Rings& rings, Step& step, double wheel_speed) {
    const std::ptrdiff_t first = step.first;
    weigh_each(rings.outer_mm.data() + first, rings.inner_mm.data() + first, rings.volume_mm3.data() + first,
               rings.strength_kpa.data() + first, step.volume_above.data(), step.volume_radius_above.data(),
               step.slope.data(), step.twist.data(), step.index.data(), rings.load_index.data() + first,
               rings.slump_axial.data() + first, rings.slump_hoop.data() + first, step.count, wheel_speed);
}

// Ring first + k of a step in which clay gives way: its slump rate, and the average of the rates from above.
void yield_ring(LoadSweep& sweep, Rings& rings, const Step& step, int k, const LoadInput& input) {
    const int i = step.first + k;
    const double index = step.index[at(k)];
    const Stress stress = step.stress(rings, k, input.wheel_speed_rad_s);
    const double equivalent = stress.equivalent_kpa();
    double rate = 0.0;
    if (index > 1.0 && input.slumps) {
        rate = std::min((index - 1.0) / kSlumpS, kFastestSlump);
        sweep.slumps = true;
        if (sweep.failure.cause == Cause::kNone) {
            sweep.failure = {stress.cause(),
                             step.centre[at(k)],
                             rings.outer_mm[at(i)],
                             index,
                             equivalent,
                             static_cast<double>(rings.strength_kpa[at(i)]),
                             input.wheel_speed_rad_s,
                             false};
        }
    }
    rings.slump_rate[at(i)] = static_cast<float>(rate);
    // Twist rotates the ring relative to the one below.
    const double sheared = std::sqrt(3.0) * rate * kSweepS *
                           (std::sqrt(3.0) * std::fabs(stress.twist_kpa) / std::max(equivalent, kLeastKpa));
    rings.shear[at(i)] += static_cast<float>(sheared);
    if (static_cast<double>(rings.shear[at(i)]) > kTornAtShear) sweep.tear_at = i;

    const bool hollow = rings.is_hollow(i);
    if (i == rings.count - 1 || hollow != sweep.last_hollow) sweep.running = static_cast<float>(0.5 * rate);
    average_in(sweep, rings, i, rate);
    rings.slump_above[at(i)] = sweep.running;
    sweep.last_hollow = hollow;
}

// The rings [first, end) on the way down, whose strength is up to date.
void weigh_rings(LoadSweep& sweep, Rings& rings, int first, int end, const LoadInput& input) {
    Step step;  // filled in as far as it is read
    step.first = first;
    step.count = end - first;
    measure(step, sweep, rings, input);
    weigh_all(rings, step, input.wheel_speed_rad_s);

    int peak = -1;
    int torn = 0;
    for (int k = step.count - 1; k >= 0; --k) {
        torn |= static_cast<double>(rings.shear[at(first + k)]) > kTornAtShear ? 1 : 0;
        if (!(step.index[at(k)] > sweep.growing_peak)) continue;
        sweep.growing_peak = step.index[at(k)];
        peak = k;
    }
    if (peak >= 0) {
        sweep.growing_height_mm = step.centre[at(peak)];
        sweep.growing_cause = step.stress(rings, peak, input.wheel_speed_rad_s).cause();
    }
    const bool yields = input.slumps && sweep.growing_peak > 1.0;
    if (yields || torn != 0 || sweep.running != 0.0F) {
        for (int k = step.count - 1; k >= 0; --k)
            yield_ring(sweep, rings, step, k, input);
    } else {
        // No rate of this round is above zero, and neither is their average.
        std::fill(rings.slump_rate.begin() + first, rings.slump_rate.begin() + end, 0.0F);
        std::fill(rings.slump_above.begin() + first, rings.slump_above.begin() + end, 0.0F);
        sweep.last_hollow = rings.is_hollow(first);
    }
}

// Brings the strength of up to `most` rings below the cursor up to date, where it is due. Returns the first
// of the rings that can be weighed in one step. A row that is folded moves its ring's faces, which the rings
// above have not seen when they are weighed, so such a ring begins a step.
int refresh_rings(const LoadSweep& sweep, Rings& rings, int most, const LoadInput& input, Changed& changed) {
    const WaterPace pace{.elapsed_s = kRefreshRounds * kSweepS,
                         .evaporation_g_mm2_s = input.evaporation_g_mm2_s,
                         .film_time_s = input.film_time_s,
                         .diffusivity_mm2_s = input.diffusivity_mm2_s};
    int first = sweep.next;
    while (first > sweep.next - most) {
        const int i = first - 1;
        if (((static_cast<std::uint64_t>(i) ^ sweep.round) & (kRefreshRounds - 1)) == 0) {
            if (first < sweep.next && rings.rough_mm[at(i)] > 0.0F) break;
            refresh_ring(rings, i, pace);
            if (tend_row(rings, i)) changed = together(changed, {i, i + 1});
        }
        first = i;
    }
    return first;
}

// Ring i on the way up: the average of slump rates from below, and the slump itself.
bool slump_ring(LoadSweep& sweep, Rings& rings, int i) {
    const bool hollow = rings.is_hollow(i);
    const auto rate = static_cast<double>(rings.slump_rate[at(i)]);
    if (i == 0 || hollow != sweep.last_hollow) sweep.running = static_cast<float>(0.5 * rate);
    average_in(sweep, rings, i, rate);
    sweep.last_hollow = hollow;
    // Rounds down and up alternate, so one slump step covers two rounds.
    const double strain =
        2.0 * kSweepS * (static_cast<double>(sweep.running) + static_cast<double>(rings.slump_above[at(i)]));
    if (!(strain > 1e-9)) return false;
    const double axial = strain * static_cast<double>(rings.slump_axial[at(i)]);
    const double hoop = strain * static_cast<double>(rings.slump_hoop[at(i)]);
    const auto stretched = [](double x) { return 1.0 + x + 0.5 * x * x; };  // e^x; |x| is below 0.15
    const double height = rings.height_mm[at(i)] * stretched(axial);
    const double area = rings.volume_mm3[at(i)] / (kPi * height);
    if (!hollow) return set_radii(rings, i, std::sqrt(area), 0.0, 1.0);
    const double mean = 0.5 * (rings.outer_mm[at(i)] + rings.inner_mm[at(i)]) * stretched(hoop);
    const double wall = area / (2.0 * mean);
    if (!(mean - 0.5 * wall > 0.0)) return false;
    return set_radii(rings, i, mean + 0.5 * wall, mean - 0.5 * wall, 1.0);
}

void finish_descent(LoadSweep& sweep) {
    sweep.peak_index = sweep.growing_peak;
    sweep.peak_height_mm = sweep.growing_height_mm;
    sweep.peak_cause = sweep.growing_cause;
    sweep.goes_up = sweep.slumps;
    sweep.next = 0;
    sweep.running = 0.0F;
}

}  // namespace

void restart(LoadSweep& sweep, const Rings& rings) noexcept {
    sweep.goes_up = false;
    sweep.next = rings.count;
    sweep.above = {};
    sweep.running = 0.0F;
    sweep.slumps = false;
    sweep.growing_peak = 0.0;
    sweep.growing_cause = Cause::kNone;
    sweep.tear_at = -1;
    ++sweep.round;
}

Changed sweep_load(LoadSweep& sweep, Rings& rings, const LoadInput& input) noexcept {
    Changed changed{};
    if (rings.count == 0) return changed;
    sweep.credit = std::min(sweep.credit + rings.count * (input.dt_s / kSweepS), 1.0 * rings.count);
    while (sweep.credit >= 1.0) {
        if (sweep.goes_up && sweep.next >= rings.count) restart(sweep, rings);
        if (sweep.goes_up) {
            sweep.credit -= 1.0;
            if (slump_ring(sweep, rings, sweep.next)) {
                changed = together(changed, {sweep.next, sweep.next + 1});
            }
            if (++sweep.next == rings.count) restart(sweep, rings);
            continue;
        }
        const int most = std::min({static_cast<int>(sweep.credit), sweep.next, Step::kMost});
        const int first = refresh_rings(sweep, rings, most, input, changed);
        weigh_rings(sweep, rings, first, sweep.next, input);
        sweep.credit -= sweep.next - first;
        sweep.next = first;
        if (sweep.next > 0) continue;
        finish_descent(sweep);
        if (!sweep.goes_up) restart(sweep, rings);
    }
    return changed;
}

void after_split(LoadSweep& sweep, int ring) noexcept {
    if (ring < sweep.next) ++sweep.next;
    if (sweep.tear_at > ring) ++sweep.tear_at;
}

void after_join(LoadSweep& sweep, int lower) noexcept {
    // A cursor between the two rings has already visited one: it continues with the joined ring's neighbour.
    if (lower + 1 < sweep.next) --sweep.next;
    if (sweep.tear_at > lower) --sweep.tear_at;
}

}  // namespace onggi::clay::studio

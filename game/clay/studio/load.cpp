#include "game/clay/studio/load.h"

#include <algorithm>
#include <cmath>

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
constexpr double kTornAtShear = 1.0;  // rad: a vertical line on the wall lies at 45 degrees

// Strength and water change slowly: each ring is refreshed once in this many rounds.
constexpr std::uint64_t kRefreshRounds = 16;

double slump_length(const Rings& rings, int i) {
    const double mean = 0.5 * (rings.outer_mm[at(i)] + rings.inner_mm[at(i)]);
    return std::max(0.5 * std::sqrt(mean * rings.wall_mm(i)), kShortestSlumpMm);
}

}  // namespace

double Stress::equivalent_kpa() const {
    const double sz = axial_kpa();
    const double sth = hoop_kpa();
    return std::sqrt(sz * sz + sth * sth - sz * sth + 3.0 * twist_kpa * twist_kpa);
}

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

Stress stress_in(const Rings& rings, int i, const Above& above, double wheel_speed, double twist) noexcept {
    const double ro = rings.outer_mm[at(i)];
    const double ri = rings.inner_mm[at(i)];
    const bool hollow = ri > 0.0;
    const double wall = ro - ri;
    const double mean = 0.5 * (ro + ri);
    const double area = kPi * wall * (ro + ri);

    Stress stress;
    stress.weight_kpa = -kWeightKpaPerMm * (above.volume_mm3 + 0.5 * rings.volume_mm3[at(i)]) / area;
    stress.spin_kpa = kSpinKpa * wheel_speed * wheel_speed * ro * ro * (hollow ? 1.0 : kSolidDisc);
    if (hollow) {
        const double slope = wall_slope(rings, i);
        stress.slope_kpa = kWeightKpaPerMm * mean * slope;
        const double along = wall / std::sqrt(1.0 + slope * slope);  // tn
        const double overhang =
            above.volume_mm3 > 0.0 ? 2.0 * std::fabs(above.volume_radius_mm4 / above.volume_mm3 - mean) : 0.0;
        const double shell = kShell * mean * along * std::fabs(slope);
        const double square = overhang * overhang;
        const double held = square + shell > 0.0 ? square * shell / (square + shell) : 0.0;  // Le^2
        stress.bending_kpa = 3.0 * kWeightKpaPerMm * held / along;
        stress.twist_kpa = kKpaPerNMm2 * twist / (kTurn * mean * mean * wall);
    } else {
        stress.twist_kpa = kKpaPerNMm2 * 2.0 * twist / (kPi * ro * ro * ro);
    }
    return stress;
}

namespace {

// Ring i on the way down: its stresses and index, and the average of slump rates from above.
void weigh_ring(LoadSweep& sweep, Rings& rings, int i, const LoadInput& input) {
    const double height = rings.centre_mm(i);
    const double twist = height < input.twist_height_mm ? input.twist_n_mm : 0.0;
    const Stress stress = stress_in(rings, i, sweep.above, input.wheel_speed_rad_s, twist);
    const double equivalent = stress.equivalent_kpa();
    const auto su = static_cast<double>(rings.strength_kpa[at(i)]);
    const double index = equivalent / (2.0 * su);
    rings.load_index[at(i)] = static_cast<float>(index);
    if (index > sweep.growing_peak) {
        sweep.growing_peak = index;
        sweep.growing_height_mm = height;
        sweep.growing_cause = stress.cause();
    }

    double rate = 0.0;
    if (index > 1.0 && input.slumps) {
        rate = std::min((index - 1.0) / kSlumpS, kFastestSlump);
        sweep.slumps = true;
        if (sweep.failure.cause == Cause::kNone) {
            sweep.failure = {stress.cause(), height, rings.outer_mm[at(i)],   index,
                             equivalent,     su,     input.wheel_speed_rad_s, false};
        }
    }
    // Levy-Mises: plastic strain is proportional to the stress deviator.
    const double mean = (stress.axial_kpa() + stress.hoop_kpa()) / 3.0;
    rings.slump_axial[at(i)] =
        static_cast<float>(1.5 * (stress.axial_kpa() - mean) / std::max(equivalent, 1e-9));
    rings.slump_hoop[at(i)] =
        static_cast<float>(1.5 * (stress.hoop_kpa() - mean) / std::max(equivalent, 1e-9));
    rings.slump_rate[at(i)] = static_cast<float>(rate);
    // Twist rotates the ring relative to the one below.
    const double sheared = std::sqrt(3.0) * rate * kSweepS *
                           (std::sqrt(3.0) * std::fabs(stress.twist_kpa) / std::max(equivalent, 1e-9));
    rings.shear[at(i)] += static_cast<float>(sheared);
    if (static_cast<double>(rings.shear[at(i)]) > kTornAtShear) sweep.tear_at = i;

    const bool hollow = rings.is_hollow(i);
    if (i == rings.count - 1 || hollow != sweep.last_hollow) sweep.running = static_cast<float>(0.5 * rate);
    const double q = rings.height_mm[at(i)] / slump_length(rings, i);
    sweep.running = static_cast<float>((static_cast<double>(sweep.running) + 0.5 * q * rate) / (1.0 + q));
    rings.slump_above[at(i)] = sweep.running;
    sweep.last_hollow = hollow;
    sweep.above.volume_mm3 += rings.volume_mm3[at(i)];
    sweep.above.volume_radius_mm4 +=
        rings.volume_mm3[at(i)] * (hollow ? 0.5 * (rings.outer_mm[at(i)] + rings.inner_mm[at(i)]) : 0.0);
}

// Ring i on the way up: the average of slump rates from below, and the slump itself.
bool slump_ring(LoadSweep& sweep, Rings& rings, int i) {
    const bool hollow = rings.is_hollow(i);
    const auto rate = static_cast<double>(rings.slump_rate[at(i)]);
    if (i == 0 || hollow != sweep.last_hollow) sweep.running = static_cast<float>(0.5 * rate);
    const double q = rings.height_mm[at(i)] / slump_length(rings, i);
    sweep.running = static_cast<float>((static_cast<double>(sweep.running) + 0.5 * q * rate) / (1.0 + q));
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
        sweep.credit -= 1.0;
        if (sweep.goes_up && sweep.next >= rings.count) restart(sweep, rings);
        if (!sweep.goes_up) {
            const int i = --sweep.next;
            if (((static_cast<std::uint64_t>(i) ^ sweep.round) & (kRefreshRounds - 1)) == 0) {
                refresh_ring(rings, i,
                             {.elapsed_s = kRefreshRounds * kSweepS,
                              .evaporation_g_mm2_s = input.evaporation_g_mm2_s,
                              .film_time_s = input.film_time_s,
                              .diffusivity_mm2_s = input.diffusivity_mm2_s});
                if (tend_row(rings, i)) changed = together(changed, {i, i + 1});
            }
            weigh_ring(sweep, rings, i, input);
            if (sweep.next > 0) continue;
            finish_descent(sweep);
            if (!sweep.goes_up) restart(sweep, rings);
        } else {
            if (slump_ring(sweep, rings, sweep.next)) {
                changed = together(changed, {sweep.next, sweep.next + 1});
            }
            if (++sweep.next == rings.count) restart(sweep, rings);
        }
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

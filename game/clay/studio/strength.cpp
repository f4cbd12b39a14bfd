#include "game/clay/studio/strength.h"

#include <algorithm>
#include <cmath>

#include "game/clay/exact_math.h"
#include "game/clay/studio/studio_parameters.h"

namespace onggi::clay::studio {
namespace {

// Plasticity index of a throwing clay: the water by dry mass between its plastic and liquid limits. And the
// dry fraction of a gram of plastic clay.
constexpr double kPlasticityIndex = 0.20;
constexpr double kDryFraction = 0.80;

constexpr double kReferenceKpa = 13.0;

// Film of a dripping face: 0.01 mm of water.
constexpr double kFilmGPerMm2 = 1e-5;

}  // namespace

double strength_kpa(double liquidity_index) {
    constexpr double kLogRatio = -4.360047727955107;  // ln(2.3/180)
    return 180.0 * exponential(kLogRatio * liquidity_index);
}

double flow_time_s(double strength, double flow_time_at_13_kpa_s) {
    return flow_time_at_13_kpa_s * std::sqrt(strength / kReferenceKpa);
}

double relaxed_fraction(double x) {
    constexpr double kSmall = 0.125;
    if (!(x < kSmall)) return 1.0 - exponential(-x);
    // x (1 - x/2 (1 - x/3 (1 - ...))): no cancellation for small x, as in a tick. Next term: x^10/10!.
    constexpr double kParts[] = {1.0 / 9, 1.0 / 8, 1.0 / 7, 1.0 / 6, 1.0 / 5, 1.0 / 4, 1.0 / 3, 1.0 / 2, 1.0};
    double series = 1.0;
    for (int k = 0; k < 8; ++k)
        series = 1.0 - x * kParts[k] * series;
    return x * series;
}

void set_liquidity(Rings& rings, int i, double liquidity_index) {
    const double liquidity = std::clamp(liquidity_index, static_cast<double>(kDriestLiquidity),
                                        static_cast<double>(kWettestLiquidity));
    rings.liquidity[Rings::at(i)] = static_cast<float>(liquidity);
    rings.strength_kpa[Rings::at(i)] = static_cast<float>(strength_kpa(liquidity));
}

namespace {

// Grams of water in ring i per unit of LI.
double water_of_index_g(const Rings& rings, int i) {
    return rings.volume_mm3[Rings::at(i)] * kDensityGPerMm3 * kDryFraction * kPlasticityIndex;
}

// Fick's law across the face between ring i and the one above, limited to half of the levelling flow. Only LI
// counts as water, so the flow is D dLI/dy.
void pass_water_up(Rings& rings, int i, double diffusivity_mm2_s, double elapsed_s) {
    if (i + 1 >= rings.count) return;
    const std::size_t a = Rings::at(i);
    const std::size_t b = Rings::at(i + 1);
    // Their common face: the overlap of both walls.
    const double outer = std::min(rings.outer_mm[a], rings.outer_mm[b]);
    const double inner = std::max(rings.inner_mm[a], rings.inner_mm[b]);
    if (!(outer > inner)) return;
    const double face_mm2 = kPi * (outer - inner) * (outer + inner);
    const double apart_mm = 0.5 * (rings.height_mm[a] + rings.height_mm[b]);
    const double wetter = static_cast<double>(rings.liquidity[a]) - static_cast<double>(rings.liquidity[b]);
    const double of_a = water_of_index_g(rings, i);
    const double of_b = water_of_index_g(rings, i + 1);
    const double wanted = diffusivity_mm2_s * elapsed_s * face_mm2 / apart_mm * kDensityGPerMm3 *
                          kDryFraction * kPlasticityIndex;
    const double levelling = 0.5 * of_a * of_b / (of_a + of_b);
    const double flow_g = wetter * std::min(wanted, levelling);
    rings.liquidity[a] -= static_cast<float>(flow_g / of_a);
    rings.liquidity[b] += static_cast<float>(flow_g / of_b);
}

}  // namespace

void refresh_ring(Rings& rings, int i, const WaterPace& pace) {
    const std::size_t at = Rings::at(i);
    pass_water_up(rings, i, pace.diffusivity_mm2_s, pace.elapsed_s);
    // Face area per volume: 2/t for a wall; 2/ro for solid clay, which has only its outer face.
    const double faces = rings.is_hollow(i) ? 2.0 / rings.wall_mm(i) : 2.0 / rings.outer_mm[at];
    const double film = static_cast<double>(rings.film[at]);
    const double soaked = film > 0.0 ? film * relaxed_fraction(pace.elapsed_s / pace.film_time_s) : 0.0;
    rings.film[at] = static_cast<float>(film - soaked);
    // A hand wets only one face.
    const double gained = 0.5 * soaked * kFilmGPerMm2;
    const double lost = pace.evaporation_g_mm2_s * pace.elapsed_s;
    const double change = (gained - lost) * faces / (kDensityGPerMm3 * kDryFraction);
    set_liquidity(rings, i, static_cast<double>(rings.liquidity[at]) + change / kPlasticityIndex);
}

void wet_faces(Rings& rings, int first, int end, const double* depth_mm, double film) {
    const auto wet = static_cast<float>(film);
    float* const faces = rings.film.data() + first;
    for (int k = 0; k < end - first; ++k)
        faces[k] = depth_mm[k] > 0.0 && wet > faces[k] ? wet : faces[k];
}

void wet_ring(Rings& rings, int i, double water_g) {
    const std::size_t at = Rings::at(i);
    rings.liquidity[at] = std::min(
        rings.liquidity[at] + static_cast<float>(water_g / water_of_index_g(rings, i)), kWettestLiquidity);
}

void drain_ring(Rings& rings, int i, double water_g, double film_fraction) {
    constexpr float kFreshLiquidity = 0.6F;
    const std::size_t at = Rings::at(i);
    rings.film[at] -= static_cast<float>(film_fraction) * rings.film[at];
    const float drained = rings.liquidity[at] - static_cast<float>(water_g / water_of_index_g(rings, i));
    rings.liquidity[at] = std::max(drained, std::min(rings.liquidity[at], kFreshLiquidity));
}

}  // namespace onggi::clay::studio

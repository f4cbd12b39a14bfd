#include "game/clay/studio/resplit.h"

#include <algorithm>
#include <cmath>

#include "game/clay/studio/rings.h"
#include "game/clay/studio/studio_parameters.h"

namespace onggi::clay::studio {
namespace {

constexpr double kSplitAbove = 1.9;       // of the target height
constexpr double kJoinBelow = 0.45;       // of the same
constexpr double kJoinedAtMost = 0.8;     // of the height that would be split again
constexpr double kSteepestPerWall = 0.2;  // of the wall, by which the halves of a split may differ
constexpr double kTallestPots = 0.75;     // a pot this many times the nominal rings high still fits

double minmod(double a, double b) {
    if (a * b <= 0.0) return 0.0;
    return std::fabs(a) < std::fabs(b) ? a : b;
}

// How much a column changes over ring i, from its neighbours of the same kind.
double change_over(const Rings& rings, const std::vector<double>& column, int i) {
    if (i == 0 || i + 1 >= rings.count) return 0.0;
    if (rings.is_hollow(i - 1) != rings.is_hollow(i) || rings.is_hollow(i + 1) != rings.is_hollow(i))
        return 0.0;
    return minmod(column[at(i)] - column[at(i - 1)], column[at(i + 1)] - column[at(i)]);
}

struct Joined {
    double height_mm;
    double fraction;  // of the lower ring
    double outer_mm;
    double inner_mm;
};

// Rings i and i + 1 as one: volume and height kept, the middle of the wall at the mean of both.
Joined joined(const Rings& rings, int i) {
    const std::size_t a = at(i);
    const std::size_t b = at(i + 1);
    Joined one{};
    one.height_mm = rings.height_mm[a] + rings.height_mm[b];
    one.fraction = rings.height_mm[a] / one.height_mm;
    const double area = (rings.volume_mm3[a] + rings.volume_mm3[b]) / (std::numbers::pi * one.height_mm);
    if (rings.is_hollow(i)) {
        const double mean = 0.5 * (one.fraction * (rings.outer_mm[a] + rings.inner_mm[a]) +
                                   (1.0 - one.fraction) * (rings.outer_mm[b] + rings.inner_mm[b]));
        const double wall = area / (2.0 * mean);
        one.outer_mm = mean + 0.5 * wall;
        one.inner_mm = mean - 0.5 * wall;
    } else {
        one.outer_mm = std::sqrt(area);
    }
    return one;
}

bool can_join(const Rings& rings, int i, double highest_mm) {
    if (i < 0 || i + 1 >= rings.count || rings.is_hollow(i) != rings.is_hollow(i + 1)) return false;
    if (rings.height_mm[at(i)] + rings.height_mm[at(i + 1)] >= highest_mm) return false;
    // Two rings that differ much, a step, may have no wall in common.
    const Joined one = joined(rings, i);
    return (one.inner_mm > 0.0) == rings.is_hollow(i) && one.outer_mm >= kNarrowestMm &&
           one.outer_mm <= kWidestMm;
}

}  // namespace

double target_height_mm(const Rings& rings, int nominal_rings) {
    const double nominal = nominal_rings;
    return std::max(200.0 / nominal, rings.top_mm() / (kTallestPots * nominal));
}

void split_ring(Rings& rings, int i) {
    const double steepest = kSteepestPerWall * rings.wall_mm(i);
    const double outer = 0.25 * std::clamp(change_over(rings, rings.outer_mm, i), -steepest, steepest);
    const double inner = rings.is_hollow(i)
                             ? 0.25 * std::clamp(change_over(rings, rings.inner_mm, i), -steepest, steepest)
                             : 0.0;
    rings.duplicate(i);
    const double volume = rings.volume_mm3[at(i)];
    const double lower = on_grid(0.5 * volume);
    rings.volume_mm3[at(i)] = lower;
    rings.volume_mm3[at(i + 1)] = volume - lower;
    rings.outer_mm[at(i)] -= outer;
    rings.outer_mm[at(i + 1)] += outer;
    rings.inner_mm[at(i)] -= inner;
    rings.inner_mm[at(i + 1)] += inner;
    for (const int half : {i, i + 1}) {
        rings.height_mm[at(half)] =
            ring_height_mm(rings.volume_mm3[at(half)], rings.outer_mm[at(half)], rings.inner_mm[at(half)]);
    }
}

void join_rings(Rings& rings, int i) {
    const std::size_t a = at(i);
    const std::size_t b = at(i + 1);
    const Joined one = joined(rings, i);
    const double fraction = one.fraction;
    const auto mixed = [&](double lower, double upper) {
        return fraction * lower + (1.0 - fraction) * upper;
    };
    const double volume = rings.volume_mm3[a] + rings.volume_mm3[b];
    rings.outer_mm[a] = one.outer_mm;
    rings.inner_mm[a] = one.inner_mm;
    rings.volume_mm3[a] = volume;
    rings.height_mm[a] = ring_height_mm(volume, rings.outer_mm[a], rings.inner_mm[a]);

    for (auto* column : {&rings.centre_x_mm, &rings.centre_z_mm, &rings.liquidity, &rings.film,
                         &rings.strength_kpa, &rings.load_index, &rings.shear, &rings.slump_rate,
                         &rings.slump_above, &rings.slump_axial, &rings.slump_hoop}) {
        (*column)[a] =
            static_cast<float>(mixed(static_cast<double>((*column)[a]), static_cast<double>((*column)[b])));
    }
    if (rings.rough_mm[a] > 0.0F || rings.rough_mm[b] > 0.0F) {
        float* lower = rings.row_of(i);
        const float* upper = rings.row_of(i + 1);
        const float of_lower = rings.rough_mm[a] > 0.0F ? static_cast<float>(fraction) : 0.0F;
        const float of_upper = rings.rough_mm[b] > 0.0F ? static_cast<float>(1.0 - fraction) : 0.0F;
        for (int s = 0; s < rings.sectors; ++s)
            lower[s] = (of_lower > 0.0F ? of_lower * lower[s] : 0.0F) +
                       (of_upper > 0.0F ? of_upper * upper[s] : 0.0F);
        rings.rough_mm[a] = std::max(rings.rough_mm[a], rings.rough_mm[b]);
    }
    rings.remove(i + 1, i + 2);
}

Resplit tend_ring(Rings& rings, int i, double target_mm) {
    const double height = rings.height_mm[at(i)];
    if (height > kSplitAbove * target_mm && rings.count < rings.capacity) {
        split_ring(rings, i);
        return {i, true};
    }
    if (height < kJoinBelow * target_mm) {
        const double highest = kJoinedAtMost * kSplitAbove * target_mm;
        const bool below = can_join(rings, i - 1, highest);
        const bool above = can_join(rings, i, highest);
        if (!below && !above) return {};
        const bool take_above = above && (!below || rings.height_mm[at(i + 1)] < rings.height_mm[at(i - 1)]);
        const int lower = take_above ? i : i - 1;
        join_rings(rings, lower);
        return {lower, false};
    }
    return {};
}

}  // namespace onggi::clay::studio

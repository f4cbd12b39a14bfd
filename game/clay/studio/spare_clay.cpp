#include "game/clay/studio/spare_clay.h"

#include <algorithm>
#include <cmath>

#include "game/clay/studio/rings.h"

namespace onggi::clay::studio {
namespace {

constexpr double kLargestGive = 0.02;  // fraction of a ring's clay that may move in one step
constexpr double kGiveReachMm = 30.0;

// Solid clay rises or sinks as a whole.
void share_among_all(Rings& rings, double free_mm3) noexcept {
    const bool gives = free_mm3 > 0.0;
    const double whole = rings.on_wheel_mm3();
    double left = free_mm3;
    for (int i = rings.count - 1; i >= 0; --i) {
        const double volume = rings.volume_mm3[at(i)];
        double part = on_grid(std::fabs(free_mm3) * volume / whole);
        part = gives ? part : -part;
        if (i == 0) part = left;
        rings.volume_mm3[at(i)] += part;
        left -= part;
    }
    rings.settle(0, rings.count);
}

// Sets the weight of each ring near y: the clay that it may take or spare. Returns their sum.
double weigh_near(const Rings& rings, std::vector<double>& weight, double y, bool gives,
                  const Rings::Range& near) noexcept {
    double whole = 0.0;
    for (int i = near.first; i < near.end; ++i) {
        const double t = rings.wall_mm(i);
        const double ri = rings.inner_mm[at(i)];
        const double dy = (rings.centre_mm(i) - y) * (1.0 / kGiveReachMm);
        const double fade = 1.0 / ((1.0 + dy * dy) * (1.0 + dy * dy));
        double want = 0.0;
        if (gives) {
            const double q = t * (1.0 / 14.0);
            const double room = ri - narrowest_bore(t) - 1.0;
            want = room > 0.0 ? room * ri * rings.height_mm[at(i)] / (1.0 + (q * q) * (q * q)) : 0.0;
        } else {
            const double spare = t - 1.25 * thinnest_mm(rings, rings.centre_mm(i));
            want = spare > 0.0 ? spare * ri * rings.height_mm[at(i)] : 0.0;
        }
        weight[at(i)] = want * fade;
        whole += want * fade;
    }
    return whole;
}

// Distributes the volume on the inner faces of the rings near y by their weights, a limited part each;
// returns the rest.
double share_near(Rings& rings, const std::vector<double>& weight, double whole, double free_mm3,
                  const Rings::Range& near) noexcept {
    const bool gives = free_mm3 > 0.0;
    double left = free_mm3;
    if (!(whole > 0.0)) return left;
    const double per_weight = std::fabs(free_mm3) / whole;
    for (int i = near.first; i < near.end; ++i) {
        if (!(weight[at(i)] > 0.0)) continue;
        const double volume = rings.volume_mm3[at(i)];
        const double part = on_grid(std::min(weight[at(i)] * per_weight, kLargestGive * volume));
        const double taken = std::min(part, std::fabs(left));
        const double signed_part = gives ? taken : -taken;
        const double outer = rings.outer_mm[at(i)];
        const double area = (volume + signed_part) / (kPi * rings.height_mm[at(i)]);
        const double square = outer * outer - area;
        if (!(square > 0.25)) continue;
        rings.volume_mm3[at(i)] = volume + signed_part;
        rings.inner_mm[at(i)] = std::sqrt(square);
        rings.height_mm[at(i)] = ring_height_mm(rings.volume_mm3[at(i)], outer, rings.inner_mm[at(i)]);
        left -= signed_part;
    }
    return left;
}

// Scales the height of the hollow rings by one fraction, or of all rings if the hollow clay is small compared
// with the volume. Returns the lowest scaled ring.
int share_in_height(Rings& rings, double left_mm3) noexcept {
    constexpr double kMostOfHollow = 0.05;
    const bool gives = left_mm3 > 0.0;
    const int first = rings.first_hollow;
    const auto sum_from = [&](int ring) {
        double sum = 0.0;
        for (int i = ring; i < rings.count; ++i)
            sum += rings.volume_mm3[at(i)];
        return sum;
    };
    const double hollow_mm3 = sum_from(first);
    const bool is_much = std::fabs(left_mm3) > kMostOfHollow * hollow_mm3;
    const int lowest = is_much ? 0 : first;
    const double fraction = std::fabs(left_mm3) / (is_much ? sum_from(0) : hollow_mm3);
    double left = left_mm3;
    for (int i = rings.count - 1; i >= lowest; --i) {
        const double volume = rings.volume_mm3[at(i)];
        double part = std::min(on_grid(fraction * volume), std::fabs(left));
        if (i == lowest) part = std::fabs(left);
        const double signed_part = gives ? part : -part;
        rings.volume_mm3[at(i)] += signed_part;
        left -= signed_part;
    }
    rings.settle(lowest, rings.count);
    return lowest;
}

}  // namespace

double thinnest_mm(const Rings& rings, double y) noexcept {
    const double floor = rings.floor_mm();
    const double depth = std::max(rings.top_mm() - floor, 1.0);
    const double s = std::clamp((y - floor) / depth, 0.0, 1.0);
    return kThinnestAtFloorMm + s * (kThinnestAtRimMm - kThinnestAtFloorMm);
}

double spare_rise(const Rings& rings) noexcept {
    double rise = 0.0;
    for (int i = rings.first_hollow; i < rings.count; ++i) {
        const double thinnest = thinnest_mm(rings, rings.centre_mm(i));
        rise += rings.height_mm[at(i)] * std::max(rings.wall_mm(i) / thinnest - 1.0, 0.0);
    }
    return rise;
}

double narrowest_bore(double wall) noexcept {
    constexpr double kThinEnoughMm = 10.0;
    constexpr double kPerMm = 0.8;
    return kNarrowestBoreMm + kPerMm * std::clamp(wall - kThinEnoughMm, 0.0, 10.0);
}

double reshape(Rings& rings, int i, double outer, double inner) noexcept {
    const double height = rings.height_mm[at(i)];
    const double before = rings.volume_mm3[at(i)];
    const double volume = on_grid(kPi * height * ((outer - inner) * (outer + inner)));
    if (!(volume > 0.0)) return 0.0;
    rings.outer_mm[at(i)] = outer;
    rings.inner_mm[at(i)] = inner;
    rings.volume_mm3[at(i)] = volume;
    rings.height_mm[at(i)] = ring_height_mm(volume, outer, inner);
    return before - volume;
}

Changed share_out(Rings& rings, std::vector<double>& weight, double y, double free_mm3) noexcept {
    if (free_mm3 == 0.0) return {};
    if (rings.first_hollow >= rings.count) {
        share_among_all(rings, free_mm3);
        return {0, rings.count};
    }
    Rings::Range near = rings.rings_between(y - 2.5 * kGiveReachMm, y + 2.5 * kGiveReachMm);
    near.first = std::max(rings.first_hollow, near.first);
    const double whole = weigh_near(rings, weight, y, free_mm3 > 0.0, near);
    const double left = share_near(rings, weight, whole, free_mm3, near);
    if (left == 0.0) return {near.first, near.end};
    const int lowest = share_in_height(rings, left);
    return {std::min(lowest, near.first), rings.count};
}

}  // namespace onggi::clay::studio

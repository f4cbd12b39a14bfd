// Conversions, used at the edges only: inside, lengths are mm, forces N, times s, angles rad.
#pragma once

#include <numbers>

namespace onggi::units {

constexpr double kMetresPerMm = 1e-3;
constexpr double kRadPerRev = 2.0 * std::numbers::pi;

constexpr double rad_s_from_rev_min(double rev_min) {
    return rev_min * kRadPerRev / 60.0;
}
constexpr double rev_min_from_rad_s(double rad_s) {
    return rad_s * 60.0 / kRadPerRev;
}

}  // namespace onggi::units

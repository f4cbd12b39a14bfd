#include "game/clay/studio/roundness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "engine/math/wide_vectors.h"
#include "game/clay/exact_math.h"
#include "game/clay/studio/moves.h"

namespace onggi::clay::studio {
namespace {

// Sixteen sectors of 256; fewer sectors are wider.
constexpr double kWindowTurns = 16.0 / 256.0;

// The row of ring i; cleared first if it counted as zero.
float* open_row(Rings& rings, int i) {
    float* row = rings.row_of(i);
    if (!(rings.rough_mm[at(i)] > 0.0F)) std::fill_n(row, rings.sectors, 0.0F);
    return row;
}

[[gnu::always_inline]] inline void centre_each(float* __restrict__ cx, float* __restrict__ cz,
                                               const double* __restrict__ depth, int n, double yield,
                                               float keep, float bx, float bz) {
    for (int k = 0; k < n; ++k) {
        const bool held = depth[k] > yield;
        cx[k] = held ? cx[k] * keep + bx : cx[k];
        cz[k] = held ? cz[k] * keep + bz : cz[k];
    }
}

ONGGI_WIDE_VECTORS void centre_all(Rings& rings, const Contact& contact, double yield, float keep, float bx,
                                   float bz) {
    const std::ptrdiff_t from = contact.touched.first;
    const std::ptrdiff_t first = contact.range.first + from;
    centre_each(rings.centre_x_mm.data() + first, rings.centre_z_mm.data() + first,
                contact.depth_mm.data() + from, contact.touched.size(), yield, keep, bx, bz);
}

}  // namespace

void centre_rings(Rings& rings, const Contact& contact, const Hand& hand, double fraction,
                  double yield) noexcept {
    centre_all(rings, contact, yield, static_cast<float>(1.0 - fraction),
               static_cast<float>(fraction * hand.wobble_mm.x),
               static_cast<float>(fraction * hand.wobble_mm.y));
}

void round_sectors(Rings& rings, const Contact& contact, const Hand& hand, int stripe,
                   const StudioParameters& parameters) noexcept {
    if (!contact.has_rough_rows) return;
    const double sign = hand.side == Side::kIn ? -1.0 : 1.0;
    const double place = turn_of(hand.in_clay) * rings.sectors;
    const double half_window = std::max(0.5 * kWindowTurns * rings.sectors, 1.0);
    const int reach = static_cast<int>(half_window) + 1;
    const int stripes = stripes_at(parameters.rate_hz);
    const double dt_s = stripes * parameters.dt_s();
    const double strength = std::min(dt_s / (kWindowTurns * parameters.rounding_time_s), 1.0);
    // Padded with ones to whole lanes of four; a row is never shorter.
    std::array<float, 24> kept{};
    kept.fill(1.0F);
    const int middle = static_cast<int>(place);
    const int width = 2 * reach + 1;
    // Raised cosine of the distance to the sector's middle; the angle advances by a fixed rotation per
    // sector.
    const double first_s = (middle - reach + 0.5 - place) / half_window;
    const Rotation step = rotation_by(kPi / half_window);
    Rotation angle = rotation_by(kPi * first_s);
    for (int j = 0; j < width; ++j) {
        const double s = first_s + j / half_window;
        const double kernel = s * s < 1.0 ? 0.5 + 0.5 * angle.cosine : 0.0;
        kept[at(j)] = static_cast<float>(1.0 - strength * kernel);
        angle = {angle.cosine * step.cosine - angle.sine * step.sine,
                 angle.sine * step.cosine + angle.cosine * step.sine};
    }
    // The window as one or two pieces of the row.
    const int lanes = (width + 3) & ~3;
    const int start = (middle - reach) & (rings.sectors - 1);
    const int before_end = std::min(lanes, rings.sectors - start);
    for (int k = 0; k < contact.range.size(); ++k) {
        const int i = contact.range.first + k;
        if (((i ^ stripe) & (stripes - 1)) != 0 || !(rings.rough_mm[at(i)] > 0.0F)) continue;
        // A hand on the mean circle rounds dents too, although it does not touch them: the test uses the
        // circle.
        const double circle = contact.depth_mm[at(k)] - sign * contact.residual_mm[at(k)];
        if (!(circle > 0.0)) continue;
        float* const row = rings.row_of(i);
        float* const piece = row + start;
        for (int j = 0; j < before_end; ++j)
            piece[j] *= kept[at(j)];
        for (int j = before_end; j < lanes; ++j)
            row[j - before_end] *= kept[at(j)];
    }
}

void dent_sectors(Rings& rings, const Contact& contact, const Hand& hand, double fraction,
                  double yield) noexcept {
    const bool inside = hand.side == Side::kIn;
    const double sign = inside ? -1.0 : 1.0;
    const double turn = turn_of(hand.in_clay);
    const double angle_a_sector = kTurn / rings.sectors;
    const int mask = rings.sectors - 1;
    const int middle = static_cast<int>(turn * rings.sectors);
    const double to_middle = (middle + 0.5 - turn * rings.sectors) * angle_a_sector;
    for (int k = 0; k < contact.range.size(); ++k) {
        const int i = contact.range.first + k;
        const double rc = contact.half_width_mm[at(k)];
        if (!(contact.depth_mm[at(k)] > yield) || !(rc > 0.1)) continue;
        if (inside && !rings.is_hollow(i)) continue;
        // The tool's circle of radius rc about r3, near its point closest to the face, as a parabola of the
        // angle: outside r3 - rc + a^2 r3 (r3 - rc)/(2 rc), inside r3 + rc - a^2 r3 (r3 + rc)/(2 rc).
        const double r3 = std::fabs(hand.distance_mm);
        const double bend = inside ? r3 * (r3 + rc) / (2.0 * rc) : r3 * std::max(r3 - rc, 0.0) / (2.0 * rc);
        const double base = contact.depth_mm[at(k)];
        float* row = open_row(rings, i);
        const double w_there = contact.has_rough_rows ? sign * contact.residual_mm[at(k)] : 0.0;
        float rough = rings.rough_mm[at(i)];
        // Walks away from the hand's direction until the tool leaves the clay, first one way, then the other
        // way.
        for (const int step : {1, -1}) {
            for (int j = step > 0 ? 0 : 1; j <= rings.sectors / 4; ++j) {
                const double angle = to_middle + step * j * angle_a_sector;
                float& w = row[(middle + step * j) & mask];
                const double depth =
                    base - w_there + sign * static_cast<double>(w) - bend * angle * angle - yield;
                if (!(depth > 0.0)) break;
                const double pressed = static_cast<double>(w) - sign * fraction * std::min(depth, kDeepestMm);
                w = static_cast<float>(std::clamp(pressed, -kLargestResidualMm, kLargestResidualMm));
                rough = std::max(rough, std::fabs(w));
            }
        }
        rings.rough_mm[at(i)] = rough;
    }
}

bool tend_row(Rings& rings, int i) noexcept {
    if (!(rings.rough_mm[at(i)] > 0.0F)) return false;
    float* row = rings.row_of(i);
    // Eight lanes, summed in a fixed order.
    std::array<double, 8> lanes{};
    for (int s = 0; s < rings.sectors; s += 8) {
        for (int lane = 0; lane < 8; ++lane)
            lanes[at(lane)] += static_cast<double>(row[s + lane]);
    }
    const double sum =
        ((lanes[0] + lanes[4]) + (lanes[2] + lanes[6])) + ((lanes[1] + lanes[5]) + (lanes[3] + lanes[7]));
    const double mean = sum / rings.sectors;
    const double inner = rings.is_hollow(i) ? rings.inner_mm[at(i)] + mean : 0.0;
    const bool moved = mean != 0.0 && (inner > 0.0 || !rings.is_hollow(i)) &&
                       set_radii(rings, i, rings.outer_mm[at(i)] + mean, inner, 1.0);
    const auto shift = moved ? static_cast<float>(mean) : 0.0F;
    float rough = 0.0F;
    for (int s = 0; s < rings.sectors; ++s) {
        row[s] -= shift;
        const float size = std::fabs(row[s]);
        rough = size > rough ? size : rough;
    }
    rings.rough_mm[at(i)] = rough < kSmoothMm ? 0.0F : rough;
    return moved;
}

}  // namespace onggi::clay::studio

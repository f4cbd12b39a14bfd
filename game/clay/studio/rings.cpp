#include "game/clay/studio/rings.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "engine/math/wide_vectors.h"
#include "game/clay/studio/studio_parameters.h"

namespace onggi::clay::studio {
namespace {

std::size_t size(int n) {
    return static_cast<std::size_t>(n);
}

// All columns with one entry a ring, by type.
constexpr std::array kDoubles{&Rings::volume_mm3, &Rings::outer_mm, &Rings::inner_mm, &Rings::height_mm,
                              &Rings::rise_mm};
constexpr std::array kFloats{&Rings::centre_x_mm, &Rings::centre_z_mm, &Rings::rough_mm,
                             &Rings::liquidity,   &Rings::film,        &Rings::strength_kpa,
                             &Rings::load_index,  &Rings::shear,       &Rings::slump_rate,
                             &Rings::slump_above, &Rings::slump_axial, &Rings::slump_hoop};

template <typename Action>
void for_each_column(Rings& rings, const Action& action) {
    for (const auto column : kDoubles)
        action(rings.*column);
    for (const auto column : kFloats)
        action(rings.*column);
    action(rings.row);
}

template <typename Action>
void for_each_pair(Rings& rings, const Rings& other, const Action& action) {
    for (const auto column : kDoubles)
        action(rings.*column, other.*column);
    for (const auto column : kFloats)
        action(rings.*column, other.*column);
    action(rings.row, other.row);
}

constexpr double kSplitAbove = 1.9;       // of the target height
constexpr double kJoinBelow = 0.45;       // of the target height
constexpr double kJoinedAtMost = 0.8;     // fraction of the height that would be split again
constexpr double kSteepestPerWall = 0.2;  // bound of a split's radius step, in wall thicknesses
constexpr double kTallestPots = 0.75;     // rings of a tall pot at the target height, as a fraction of N

double minmod(double a, double b) {
    if (a * b <= 0.0) return 0.0;
    return std::fabs(a) < std::fabs(b) ? a : b;
}

// The change of a column across ring i, from neighbours of the same kind.
double change_over(const Rings& rings, const std::vector<double>& column, int i) {
    if (i == 0 || i + 1 >= rings.count) return 0.0;
    if (rings.is_hollow(i - 1) != rings.is_hollow(i) || rings.is_hollow(i + 1) != rings.is_hollow(i))
        return 0.0;
    return minmod(column[at(i)] - column[at(i - 1)], column[at(i + 1)] - column[at(i)]);
}

struct Joined {
    double height_mm;
    double fraction;  // weight of the lower ring
    double outer_mm;
    double inner_mm;
};

// Rings i and i + 1 as one: keeps volume and height; the middle of the wall is the mean of both.
Joined joined(const Rings& rings, int i) {
    const std::size_t a = at(i);
    const std::size_t b = at(i + 1);
    Joined one{};
    one.height_mm = rings.height_mm[a] + rings.height_mm[b];
    one.fraction = rings.height_mm[a] / one.height_mm;
    const double area = (rings.volume_mm3[a] + rings.volume_mm3[b]) / (kPi * one.height_mm);
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
    // Two very different rings, a step, may have no common wall.
    const Joined one = joined(rings, i);
    return (one.inner_mm > 0.0) == rings.is_hollow(i) && one.outer_mm >= kNarrowestMm &&
           one.outer_mm <= kWidestMm;
}

}  // namespace

Rings::Rings(int ring_capacity, int sector_count)
    : capacity(ring_capacity),
      sectors(sector_count),
      residual_mm(size(ring_capacity) * size(sector_count)),
      free_rows(size(ring_capacity), 0),
      base_mm(size(ring_capacity / kBlockRings + 2), 0.0) {
    assert(ring_capacity > 0 && ring_capacity <= 8000);
    assert(sector_count > 0 && (sector_count & (sector_count - 1)) == 0);
    for_each_column(*this, [&](auto& column) { column.assign(size(ring_capacity), {}); });
    reset(0);
}

void Rings::reset(int rings) {
    assert(rings >= 0 && rings <= capacity);
    for_each_column(*this, [](auto& column) { std::fill(column.begin(), column.end(), 0); });
    count = rings;
    first_hollow = rings;
    for (int i = 0; i < rings; ++i)
        row[at(i)] = static_cast<std::uint16_t>(i);
    free_count = capacity - rings;
    for (int i = 0; i < free_count; ++i)
        free_rows[at(i)] = static_cast<std::uint16_t>(capacity - 1 - i);
    place(0, count);
}

double Rings::on_wheel_mm3() const {
    double sum = 0.0;  // whole grains: exact in any order
    for (int i = 0; i < count; ++i)
        sum += volume_mm3[at(i)];
    return sum;
}

int Rings::ring_at(double y_mm) const {
    assert(count > 0);
    int first = 0;
    int last = count - 1;
    while (first < last) {
        const int middle = (first + last + 1) / 2;
        if (bottom_mm(middle) <= y_mm)
            first = middle;
        else
            last = middle - 1;
    }
    return first;
}

Rings::Range Rings::rings_between(double low_mm, double high_mm) const {
    if (count == 0 || !(high_mm >= low_mm) || high_mm < 0.0 || low_mm > top_) return {};
    int first = ring_at(low_mm);
    int end = ring_at(high_mm) + 1;
    if (centre_mm(first) < low_mm) ++first;
    if (centre_mm(end - 1) > high_mm) --end;
    return {first, std::max(first, end)};
}

namespace {

// Calls each(first, n, base_mm) for the rings of the range, block by block.
template <typename Action>
[[gnu::always_inline]] inline void for_each_block(const Rings& rings, const Rings::Range& range,
                                                  const Action& each) {
    for (int i = range.first; i < range.end;) {
        const int block = i / kBlockRings;
        const int end = std::min(range.end, (block + 1) * kBlockRings);
        each(i, end - i, rings.base_mm[at(block)]);
        i = end;
    }
}

ONGGI_WIDE_VECTORS void find_centres(const Rings& rings, const Rings::Range& range, double* out) {
    for_each_block(rings, range, [&](int first, int n, double base) {
        const double* __restrict__ const rise = rings.rise_mm.data() + first;
        const double* __restrict__ const height = rings.height_mm.data() + first;
        double* __restrict__ const found = out + (first - range.first);
        for (int k = 0; k < n; ++k)
            found[k] = centre_above(base, rise[k], height[k]);
    });
}

ONGGI_WIDE_VECTORS void find_offsets(const Rings& rings, const Rings::Range& range, double from_mm,
                                     double* out) {
    for_each_block(rings, range, [&](int first, int n, double base) {
        const double* __restrict__ const rise = rings.rise_mm.data() + first;
        const double* __restrict__ const height = rings.height_mm.data() + first;
        double* __restrict__ const found = out + (first - range.first);
        const double from_base = base - from_mm;
        for (int k = 0; k < n; ++k)
            found[k] = from_base + (rise[k] + 0.5 * height[k]);
    });
}

// Places the rings of whole blocks before `end`, kChains blocks side by side: each sum waits for its previous
// addition, so that the sums of several blocks overlap. Returns the first block that is left.
template <int kChains>
int place_blocks(double* __restrict__ rise_mm, const double* __restrict__ height_mm, int block, int end) {
    for (; block + kChains <= end; block += kChains) {
        std::array<double, std::size_t{kChains}> rise{};
        const std::ptrdiff_t first = block * kBlockRings;
        for (std::ptrdiff_t i = first; i < first + kBlockRings; ++i) {
            for (int chain = 0; chain < kChains; ++chain) {
                rise_mm[i + chain * kBlockRings] = rise[at(chain)];
                rise[at(chain)] += height_mm[i + chain * kBlockRings];
            }
        }
    }
    return block;
}

}  // namespace

void Rings::centres(Range range, double* out) const {
    find_centres(*this, range, out);
}

void Rings::centres_from(double from_mm, Range range, double* out) const {
    find_offsets(*this, range, from_mm, out);
}

void Rings::place(int first, int end) {
    const int blocks = (count + kBlockRings - 1) / kBlockRings;
    const int first_block = first / kBlockRings;
    const int last_block = std::min(blocks, (end + kBlockRings - 1) / kBlockRings);
    const int whole_end = std::min(last_block, count / kBlockRings);
    int block = first_block;
    block = place_blocks<8>(rise_mm.data(), height_mm.data(), block, whole_end);
    block = place_blocks<4>(rise_mm.data(), height_mm.data(), block, whole_end);
    block = place_blocks<2>(rise_mm.data(), height_mm.data(), block, whole_end);
    for (; block < last_block; ++block) {
        const int stop = std::min(count, (block + 1) * kBlockRings);
        double rise = 0.0;
        for (int i = block * kBlockRings; i < stop; ++i) {
            rise_mm[at(i)] = rise;
            rise += height_mm[at(i)];
        }
    }
    for (block = first_block; block < blocks; ++block) {
        const int last = std::min(count, (block + 1) * kBlockRings) - 1;
        base_mm[at(block + 1)] = base_mm[at(block)] + (rise_mm[at(last)] + height_mm[at(last)]);
    }
    top_ = base_mm[at(blocks)];
}

void Rings::settle(int first, int end) {
    for (int i = first; i < end; ++i)
        height_mm[at(i)] = ring_height_mm(volume_mm3[at(i)], outer_mm[at(i)], inner_mm[at(i)]);
    place(first, end);
}

void Rings::find_floor() {
    first_hollow = 0;
    while (first_hollow < count && !is_hollow(first_hollow))
        ++first_hollow;
}

void Rings::copy_from(const Rings& other) noexcept {
    assert(capacity == other.capacity && sectors == other.sectors);
    count = other.count;
    first_hollow = other.first_hollow;
    free_count = other.free_count;
    top_ = other.top_;
    for_each_pair(*this, other, [&](auto& column, const auto& from) {
        std::copy_n(from.begin(), size(count), column.begin());
    });
    std::copy_n(other.free_rows.begin(), size(free_count), free_rows.begin());
    std::copy_n(other.base_mm.begin(), base_mm.size(), base_mm.begin());
    // The rows of round rings count as zero, whatever their contents.
    for (int i = 0; i < count; ++i) {
        if (rough_mm[at(i)] > 0.0F) std::copy_n(other.row_of(i), sectors, row_of(i));
    }
}

// Moves the rings [from, count) so that they start at `to`.
void Rings::shift(int from, int to) {
    for_each_column(*this, [&](auto& column) {
        if (to > from)
            std::copy_backward(column.begin() + from, column.begin() + count,
                               column.begin() + count + (to - from));
        else
            std::copy(column.begin() + from, column.begin() + count, column.begin() + to);
    });
    count += to - from;
}

void Rings::duplicate(int i) {
    assert(count < capacity && free_count > 0);
    const std::uint16_t fresh = free_rows[at(--free_count)];
    shift(i, i + 1);  // ring i keeps its source position: both indices hold a copy now
    row[at(i + 1)] = fresh;
    if (rough_mm[at(i)] > 0.0F) std::copy_n(row_of(i), sectors, row_of(i + 1));
    if (i < first_hollow) ++first_hollow;
}

void Rings::remove(int first, int end) {
    for (int i = first; i < end; ++i)
        free_rows[at(free_count++)] = row[at(i)];
    shift(end, first);
    if (first_hollow >= end)
        first_hollow -= end - first;
    else if (first_hollow > first)
        first_hollow = first;
}

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

namespace {

// A ring below the first height is joined if it can be; one above the second is split.
struct HeightBounds {
    double least_mm;
    double most_mm;
};

HeightBounds height_bounds(double target_mm) {
    return {kJoinBelow * target_mm, kSplitAbove * target_mm};
}

ONGGI_WIDE_VECTORS int first_outside(const double* height, int first, int end, const HeightBounds& bounds) {
    constexpr int kPiece = 16;
    const auto [least, most] = bounds;
    int i = first;
    for (; i + kPiece <= end; i += kPiece) {
        std::int64_t outside = 0;
        for (int k = 0; k < kPiece; ++k)
            outside |= (height[i + k] > most ? 1 : 0) | (height[i + k] < least ? 1 : 0);
        if (outside != 0) break;
    }
    while (i < end && !(height[i] > most) && !(height[i] < least))
        ++i;
    return i;
}

}  // namespace

int first_to_tend(const Rings& rings, Rings::Range range, double target_mm) {
    return first_outside(rings.height_mm.data(), range.first, range.end, height_bounds(target_mm));
}

Resplit tend_ring(Rings& rings, int i, double target_mm) {
    const double height = rings.height_mm[at(i)];
    const HeightBounds bounds = height_bounds(target_mm);
    if (height > bounds.most_mm && rings.count < rings.capacity) {
        split_ring(rings, i);
        return {i, true};
    }
    if (height < bounds.least_mm) {
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

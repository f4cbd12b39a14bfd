// A pot's clay for export, from either kind of clay: a stack of rings, each with an outer and an inner face.
// Any thread but the haptic one. mm, wet size, the clay's frame: x along its direction 0, y up.
#pragma once

#include <span>
#include <vector>

#include "engine/core/result.h"
#include "engine/math/math.h"
#include "game/clay/studio/rings.h"

namespace onggi::exporter {

// Limits of a pot: within them every pot becomes a mesh without degenerate triangles in float metres.
constexpr double kMinHeightMm = 1.0;
constexpr double kMaxHeightMm = 2000.0;
constexpr double kMinRadiusMm = 0.1;
constexpr double kMaxRadiusMm = 1000.0;
constexpr std::size_t kMaxRings = 200000;

// Columns, bottom first. A column is empty if the clay does not have that property.
struct PotRings {
    std::vector<double> edge_mm{};  // lower edge of each ring, and the upper edge of the last
    std::vector<double> outer_mm{};
    std::vector<double> inner_mm{};  // 0 if solid; empty: solid everywhere
    std::vector<dvec2> centre_mm{};  // of each ring; empty: all on the axis
    std::vector<float> dents_mm{};   // `sectors` values a ring, added to both faces; empty: round everywhere
    int sectors = 0;
    double volume_mm3 = 0.0;  // from the clay's own ledger

    [[nodiscard]] int count() const { return static_cast<int>(outer_mm.size()); }
    [[nodiscard]] double height_mm() const { return edge_mm.empty() ? 0.0 : edge_mm.back(); }
    [[nodiscard]] double bottom_mm(int i) const { return edge_mm[at(i)]; }
    [[nodiscard]] double middle_mm(int i) const { return 0.5 * (edge_mm[at(i)] + edge_mm[at(i) + 1]); }
    [[nodiscard]] double ring_mm(int i) const { return edge_mm[at(i) + 1] - edge_mm[at(i)]; }
    [[nodiscard]] double inner(int i) const { return inner_mm.empty() ? 0.0 : inner_mm[at(i)]; }
    [[nodiscard]] bool is_hollow(int i) const { return inner(i) > 0.0; }
    [[nodiscard]] std::span<const float> dents_of(int i) const {
        if (dents_mm.empty()) return {};
        return std::span(dents_mm).subspan(at(i) * at(sectors), at(sectors));
    }

    static std::size_t at(int i) { return static_cast<std::size_t>(i); }
};

// From the studio's clay, with all its properties.
[[nodiscard]] PotRings rings_of(const clay::studio::Rings& rings);
// From the paper's clay: elements of equal height and no inside; clay::PaperClay has both values.
[[nodiscard]] PotRings rings_of(double height_mm, std::span<const float> radii_mm);

// kBadInput naming the ring or the measure outside the limits above.
Result<void> check_rings(const PotRings& rings);

// Halves the number of rings over the same height: two neighbours of the same kind become one, with the radii
// of the lower one (kEverySecond) or with the clay of both (kMerged). The count stays if no neighbours are of
// the same kind.
enum class Halving { kEverySecond, kMerged };
[[nodiscard]] PotRings halved(const PotRings& rings, Halving how);

}  // namespace onggi::exporter

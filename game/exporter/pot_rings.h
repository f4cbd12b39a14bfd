// A pot's clay as it leaves, whichever clay it was thrown of: a stack of rings, each with an outer and an
// inner face. Any thread but the haptic one. mm, wet size, the clay's frame: x along its direction 0, y up.
#pragma once

#include <span>
#include <vector>

#include "engine/core/result.h"
#include "engine/math/math.h"
#include "game/clay/studio/rings.h"

namespace onggi::exporter {

// What a pot may be, so that every pot within it becomes a mesh without degenerate triangles in float metres.
constexpr double kMinHeightMm = 1.0;
constexpr double kMaxHeightMm = 2000.0;
constexpr double kMinRadiusMm = 0.1;
constexpr double kMaxRadiusMm = 1000.0;
constexpr std::size_t kMaxRings = 200000;

// Columns, bottom first. Those of what the clay does not have are empty.
struct PotRings {
    std::vector<double> edge_mm{};  // the lower edge of each ring, and at the end the upper edge of the last
    std::vector<double> outer_mm{};
    std::vector<double> inner_mm{};  // 0 where solid; empty: solid everywhere
    std::vector<dvec2> centre_mm{};  // of each ring; empty: all on the axis
    std::vector<float> dents_mm{};   // `sectors` of each ring, added to both faces; empty: round everywhere
    int sectors = 0;
    double volume_mm3 = 0.0;  // as the clay's own ledger has it

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

// The studio's clay, with all it has.
[[nodiscard]] PotRings rings_of(const clay::studio::Rings& rings);
// The paper's clay: elements of equal height and no inside; clay::PaperClay gives both.
[[nodiscard]] PotRings rings_of(double height_mm, std::span<const float> radii_mm);

// kBadInput naming the ring or the measure that is outside the limits above.
Result<void> check_rings(const PotRings& rings);

// About half as many rings over the same height: of two neighbours of the same kind one, as wide as the
// lower, or such that it holds the clay of both. As many as before if no neighbours are of the same kind.
enum class Halving { kEverySecond, kMerged };
[[nodiscard]] PotRings halved(const PotRings& rings, Halving how);

}  // namespace onggi::exporter

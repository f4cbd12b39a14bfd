// How near a thrown pot comes to a target, in a museum's own units, and which target it resembles. Any thread
// but the haptic one. mm, g, ml.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/clay/studio/pot.h"
#include "game/clay/studio/studio_clay.h"
#include "game/heritage/target.h"

namespace onggi::heritage {

// A pot as a museum measures it, fired. Radii are of the outside at evenly spaced heights from foot to rim.
struct PotForm {
    double height_mm = 0.0;
    std::vector<double> radii_mm;       // kFormSamples
    std::optional<double> wall_mm;      // the mean over the height of the hollow part
    std::optional<double> capacity_ml;  // up to the rim
    std::optional<double> mass_g;

    [[nodiscard]] double widest_mm() const;  // diameters
    [[nodiscard]] double mouth_mm() const { return 2.0 * radii_mm.back(); }
    [[nodiscard]] double foot_mm() const { return 2.0 * radii_mm.front(); }
};
constexpr std::size_t kFormSamples = 129;

// The studio clay's pot after its glaze fire. Precondition: clay on the wheel.
PotForm form_of(const clay::StudioClay& clay);
// The outline of a target, as large as it is.
PotForm form_of(const Target& target);

// What there is to throw with, and the walls that come of it.
struct ThrownClay {
    double most_g = 2500.0;
    double wall_mm = 6.0;
};

// The size at which a target is thrown: the largest of 1, 3/4, 2/3, 1/2, 1/3, 1/4 and 1/5 of it that, wet,
// stays within the wheel head, the tallest pot and that clay, with a floor of 8 mm.
struct ThrownSize {
    double fraction = 1.0;   // of the museum's pot
    double wet_scale = 1.0;  // of the museum's pot on the wheel: fraction/(1 - s)
    std::string text;        // "full size", "half size", ...
    std::string part;        // "1", "1/2", ...
};
ThrownSize thrown_size(const Target& target, clay::ClayBody body, const ThrownClay& clay = {});

// One measure beside the target's. Without a published one the target's is missing, and the measure counts
// for nothing.
struct Measure {
    std::string name;  // with its unit: height_mm, widest_mm, mouth_mm, foot_mm, wall_mm, capacity_ml, mass_g
    double pot = 0.0;
    std::optional<double> target;  // at the thrown size
};

struct Score {
    ThrownSize size;
    std::vector<Measure> measures;
    // Root mean square of the radius difference at 129 equal shares of the height. The outline is published
    // in its marked points and ours between them.
    double profile_rms_mm = 0.0;
    std::size_t published_points = 0;
    std::size_t drawn_points = 0;
    // Mean size of the differences of all lengths that are published, mm.
    double mean_off_mm = 0.0;
};
Score score(const PotForm& pot, const Target& target, clay::ClayBody body);

// How unlike two outlines are whatever their size: 0 the same, 1 nothing in common. Radii and heights of the
// samples as one long vector each; the sine of the angle between the two.
double unlikeness(const PotForm& a, const PotForm& b);

struct Nearest {
    std::size_t target = 0;  // place in the list
    double unlikeness = 0.0;
};
// Precondition: targets is not empty.
Nearest nearest(const PotForm& pot, std::span<const Target> targets);

// What `throw --target` says: one line a measure.
std::string report(const Score& score, const Target& target);

}  // namespace onggi::heritage

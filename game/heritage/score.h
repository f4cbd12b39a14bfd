// The score of a thrown pot against a target in a museum's units, and the target of the nearest shape. Any
// thread but the haptic one. mm, g, ml.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "game/clay/studio/pot.h"
#include "game/clay/studio/studio_clay.h"
#include "game/heritage/target.h"

namespace onggi::heritage {

// The fired pot in a museum's measures. Radii are of the outside at evenly spaced heights from foot to rim.
struct PotForm {
    double height_mm = 0.0;
    std::vector<double> radii_mm;       // kFormSamples values
    std::optional<double> wall_mm;      // the mean over the height of the hollow part
    std::optional<double> capacity_ml;  // up to the rim
    std::optional<double> mass_g;

    [[nodiscard]] double widest_mm() const;  // diameter, as the next two
    [[nodiscard]] double mouth_mm() const { return 2.0 * radii_mm.back(); }
    [[nodiscard]] double foot_mm() const { return 2.0 * radii_mm.front(); }
};
constexpr std::size_t kFormSamples = 129;

// The studio clay's pot after its glaze fire. Precondition: clay on the wheel.
PotForm form_of(const clay::StudioClay& clay);
// The outline of a target at full size.
PotForm form_of(const Target& target);

// The clay for a pot, and the resulting wall.
struct ThrownClay {
    double most_g = 2500.0;
    double wall_mm = 6.0;
};

// The size at which a target is thrown: the largest fraction of 1, 3/4, 2/3, 1/2, 1/3, 1/4 and 1/5 that, wet,
// stays within the wheel head, the tallest pot and that clay, with a floor of 8 mm.
struct ThrownSize {
    double fraction = 1.0;   // of the museum's pot
    double wet_scale = 1.0;  // of the museum's pot on the wheel: fraction/(1 - s)
    std::string text;        // "full size", "half size", ...
    std::string part;        // "1", "1/2", ...
};
ThrownSize thrown_size(const Target& target, clay::ClayBody body, const ThrownClay& clay = {});

// One measure beside the target's. Without a published value the target's is empty, and the measure does not
// count.
struct Measure {
    std::string name;  // with its unit: height_mm, widest_mm, mouth_mm, foot_mm, wall_mm, capacity_ml, mass_g
    double pot = 0.0;
    std::optional<double> target;  // scaled to the thrown size
};

struct Score {
    ThrownSize size;
    std::vector<Measure> measures;
    double profile_rms_mm = 0.0;
    std::size_t published_points = 0;
    std::size_t drawn_points = 0;
    // Mean absolute difference of all published lengths, mm.
    double mean_off_mm = 0.0;
};
Score score(const PotForm& pot, const Target& target, clay::ClayBody body);

// Root mean square of the radius difference at kFormSamples evenly spaced heights, from the target at that
// fraction of its size. The outline is published at its marked points; we drew the rest.
double profile_rms_mm(const PotForm& pot, const Target& target, double fraction);

// Difference of two outlines regardless of size: 0 equal, 1 nothing in common. The sine of the angle between
// the vectors of their samples' radii and heights.
double unlikeness(const PotForm& a, const PotForm& b);

struct Nearest {
    std::size_t target = 0;  // index in the list
    double unlikeness = 0.0;
};
// Precondition: targets is not empty.
Nearest nearest(const PotForm& pot, std::span<const Target> targets);

// The text of `throw --target`: one line a measure.
std::string report(const Score& score, const Target& target);

}  // namespace onggi::heritage

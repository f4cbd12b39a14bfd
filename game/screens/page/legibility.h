// The text size that is legible from the configured distance. EN 301 549, 5.1.4: capitals of at least 0.7
// degrees. Any thread; pure. Lengths as named.
#pragma once

namespace onggi::screens {

constexpr double kLeastCapitalDegrees = 0.7;
constexpr double kLeastTargetMm = 20.0;

// For a panel of that diagonal, which the picture fills.
[[nodiscard]] double px_per_mm(int width_px, int height_px, double diagonal_inch);

// The visual angle of capitals at that text size, for the family in use with the lowest capitals.
[[nodiscard]] double capital_degrees(double size_u, double mm_per_u, double distance_mm);

// That of the smallest words on any screen.
[[nodiscard]] double smallest_text_degrees(int width_px, int height_px, double px_per_mm, double distance_mm);

// The smaller side of the smallest target on any screen, mm.
[[nodiscard]] double smallest_target_mm(int width_px, int height_px, double px_per_mm);

// The factor by which words must be larger than in the design to be legible from there: 1 where the design
// suffices, at most 2, beyond which words do not fit their boxes.
[[nodiscard]] float legible_scale(double mm_per_u, double distance_mm);

}  // namespace onggi::screens

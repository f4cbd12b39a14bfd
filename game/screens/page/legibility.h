// How large words must be for whoever stands at the configured distance. EN 301 549, 5.1.4: capitals of at
// least 0.7 degrees. Any thread; pure. Lengths as named.
#pragma once

namespace onggi::screens {

constexpr double kLeastCapitalDegrees = 0.7;
constexpr double kLeastTargetMm = 20.0;

// Of a panel of that diagonal, which the picture fills.
[[nodiscard]] double px_per_mm(int width_px, int height_px, double diagonal_inch);

// Of capitals in words of that size, by the lowest capitals of the families that are used.
[[nodiscard]] double capital_degrees(double size_u, double mm_per_u, double distance_mm);

// Of the smallest words there are on a screen.
[[nodiscard]] double smallest_text_degrees(int width_px, int height_px, double px_per_mm, double distance_mm);

// The smaller side of the smallest target there is on a screen, mm.
[[nodiscard]] double smallest_target_mm(int width_px, int height_px, double px_per_mm);

// How many times larger than designed words have to be to be read from there; 1 where the design will do, 2
// at most: beyond it no box holds a word.
[[nodiscard]] float legible_scale(double mm_per_u, double distance_mm);

}  // namespace onggi::screens

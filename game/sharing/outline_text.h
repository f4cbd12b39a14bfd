// A pot's outline as the page has it: numbers for the script that draws the pot, and a drawn shape. Any
// thread; pure.
#pragma once

#include <span>
#include <string>

#include "game/sharing/shared_pot.h"

namespace onggi::sharing {

// "50,0 54.2,5 ..." radius and height, mm to a tenth; at most 160 points, the first and the last among them.
// What is not finite or beyond two metres ends it.
[[nodiscard]] std::string outline_numbers(std::span<const OutlinePoint> outline);

// Two pots on one board at one scale, as SVG without words: ours, and the museum's after it.
[[nodiscard]] std::string two_pots_svg(std::span<const OutlinePoint> ours,
                                       std::span<const OutlinePoint> nearest);

}  // namespace onggi::sharing

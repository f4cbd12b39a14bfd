// How a map of dents is laid out, for what makes it and what draws it. Constant; any thread.
#pragma once

namespace onggi {

// Directions of a row, counter-clockwise in the turned body's own frame, the first sector from +X on.
constexpr int kDentSectors = 64;

}  // namespace onggi

// The layout of a dent map, for its producer and the renderer. Constant; any thread.
#pragma once

namespace onggi {

// Sectors per row, counter-clockwise in the rotating body's frame; the first starts at +X.
constexpr int kDentSectors = 64;

}  // namespace onggi

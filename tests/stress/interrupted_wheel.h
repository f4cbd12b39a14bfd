// Shared by interrupted_wheel.cpp, which is killed, and interrupted_test.cpp, which kills it.
#pragma once

#include <cstdint>

#include "game/haptic/tick.h"

namespace onggi::stress {

constexpr double kRateHz = 4000.0;  // a block of the journal every quarter of a second
constexpr int kMostPots = 12;
// Two blocks of the journal, plus the time that a keeper may need to write them. A program killed sooner
// loses the last quarter of a second or two.
constexpr std::uint64_t kTicksToKeep = 3000;

inline haptic::HapticState start() {
    return haptic::HapticState(clay::StudioClay({.mass_g = 400.0, .rings = 400}));
}

// The bytes on standard output.
constexpr char kThrows = 't';
constexpr char kResumed = 'r';
constexpr char kThrewOn = 'T';  // for kTicksToKeep, on new clay, and throws on
constexpr char kThrown = 'h';
constexpr char kSaves = 's';
constexpr char kSaved = 'S';
constexpr char kGone = 'g';

}  // namespace onggi::stress

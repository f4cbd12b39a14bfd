// The words for what a hand holds, where it means to be, and what is done to the clay at once. Their numbers
// are in files: never renumber.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace onggi::tool {

// What a hand holds.
enum class Tool : std::uint8_t {
    kHand = 0,     // nothing. Pushes: cone, collar, belly, open, widen, pinch, press the rim
    kRib = 1,      // smooths: the touched face follows its own average, no push
    kSponge = 2,   // the same over a shorter length; adds water, carries off slip
    kTrimmer = 3,  // cuts: the clay in reach goes to the trimmings
    kWire = 4,     // held at a height around the pot; touches no clay until it is pulled
};
// The tools that touch clay: those of sessions and gestures. A wire in the hand is an empty hand there.
constexpr unsigned kClayTools = 4;
constexpr std::array<std::string_view, kClayTools> kToolWords{"hand", "rib", "sponge", "trimmer"};

// The side of the wall that a hand is on or means to come to. A wish decides nothing once the hand is there,
// and takes no hand through a wall.
enum class Side : std::uint8_t {
    kFree = 0,  // on none; as a wish: the side it comes from
    kOut = 1,
    kIn = 2,
    kTop = 3,  // on the rim
};
constexpr std::array<std::string_view, 4> kSideWords{"auto", "outer", "inner", "rim"};

// A cut of the wire; one pull cuts once.
enum class Wire : std::uint8_t {
    kNone = 0,
    kCutRim = 1,  // level: the clay above goes to the trimmings
    kCutOff = 2,  // under the pot: the clay below stays on the wheel, and the pot is done
};
constexpr std::array<std::string_view, 3> kWireWords{"none", "rim", "off"};

}  // namespace onggi::tool

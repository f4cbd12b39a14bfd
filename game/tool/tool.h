// The vocabulary of a hand: its tools, the side of the wall that it aims at, and the cuts of the wire. The
// numbers are in files: never renumber.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace onggi::tool {

// The tool in a hand.
enum class Tool : std::uint8_t {
    kHand = 0,     // no tool: cones, collars, bellies, opens, widens, pinches, presses the rim
    kRib = 1,      // smooths: the touched face follows its own average, no push
    kSponge = 2,   // the same over a shorter length; adds water and removes slip
    kTrimmer = 3,  // cuts: the clay in reach goes to the trimmings
    kWire = 4,     // held at a height around the pot; does not touch the clay until it is pulled
};
// The tools that can touch clay, as used in sessions and gestures. A hand with the wire is stored as an empty
// hand.
constexpr unsigned kClayTools = 4;
constexpr std::array<std::string_view, kClayTools> kToolWords{"hand", "rib", "sponge", "trimmer"};
// Whether it scrapes the clay rather than slides on it.
[[nodiscard]] constexpr bool is_hard(Tool held) {
    return held == Tool::kRib || held == Tool::kTrimmer;
}

// The side of the wall that a hand is on or aims at. The aim has no effect once the hand is at the clay, and
// never takes a hand through a wall.
enum class Side : std::uint8_t {
    kFree = 0,  // on no side; as an aim: the side that the hand comes from
    kOut = 1,
    kIn = 2,
    kTop = 3,  // on the rim
};
constexpr std::array<std::string_view, 4> kSideWords{"auto", "outer", "inner", "rim"};

// A cut of the wire; one pull cuts once.
enum class Wire : std::uint8_t {
    kNone = 0,
    kCutRim = 1,  // horizontal: the clay above it goes to the trimmings
    kCutOff = 2,  // under the pot: the clay below stays on the wheel, and the pot is finished
};
constexpr std::array<std::string_view, 3> kWireWords{"none", "rim", "off"};

}  // namespace onggi::tool

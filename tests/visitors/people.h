// Simulated visitors, who know only what the screen shows, and aim and move like people. A kind and a seed
// determine each, so that a pot can be thrown again. They model intention and error only; the clay decides
// the result.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "tests/visitors/wheel_rig.h"

namespace onggi::visitors {

enum class Kind {
    kLesson,          // does the three steps as the screen shows them
    kLeftHand,        // the same from the left
    kTopFirst,        // presses on top before anything else
    kOutsidePull,     // draws the outside up, again and again
    kBowl,            // draws the outline of a bowl
    kVase,            // draws the outline of a vase
    kScribble,        // a child, for half a minute
    kLiftsOften,      // never presses for more than half a second
    kHoldsStill,      // presses and waits
    kTrembles,        // a slow hand with a tremor, and pauses of up to 15 s
    kWorksAtBase,     // rubs the foot until the clay is open, then draws up
    kPullsInside,     // opens, then draws up from inside the mouth
    kStartsAside,     // begins every drag on the bench or among the buttons
    kPlate,           // wants a plate: draws the clay outward and the rim down
    kStirs,           // stirs round the middle, then draws the sides up
    kTaps,            // taps, a tenth to a third of a second each
    kSwipes,          // flicks, as on a telephone
    kTraces,          // traces the profile of a bottle, a jar or a cylinder
    kSlow,            // the lesson with the strokes of a slow, steady hand
    kBothSides,       // draws the left and the right side up by turns
    kDownward,        // opens, then strokes the outside from the rim down, and up again
    kFollowsOutline,  // draws the outline that is shown on the clay
};
constexpr int kKindCount = 21;     // number of kinds above that follow no outline
constexpr int kEarlierKinds = 9;   // the first kinds, whose seeds are of that many kinds
constexpr int kReservedFrom = 14;  // kinds from kStirs on: no value of the clay was chosen by them
constexpr std::array<std::string_view, kKindCount + 1> kKindNames{"lesson",       "left hand",
                                                                  "top first",    "outside pull",
                                                                  "bowl",         "vase",
                                                                  "scribble",     "lifts often",
                                                                  "holds still",  "trembles",
                                                                  "at base",      "pulls inside",
                                                                  "starts aside", "plate",
                                                                  "stirs",        "taps",
                                                                  "swipes",       "traces",
                                                                  "slow",         "both sides",
                                                                  "downward",     "follows an outline"};

// How one of them aims: standard deviations in mm. 4.8 mm are ten pixels of a screen 1280 wide. And whether
// they do what the screen says at "done".
struct Skill {
    double aim_mm = 4.8;
    double wander_mm = 1.5;
    double tremor_mm = 0.0;   // amplitude, at 5 Hz
    bool heeds_done = false;  // opens or draws up where "done" advises it, twice at most
};

struct Visit {
    double seconds = 0.0;         // to the last release
    int advised = 0;              // how often they did what "done" advised
    double made_s = -1.0;         // until the clay was hollow and raised; -1: never
    std::vector<dvec2> drawn_mm;  // the intended outline, radius and height from below; empty: no outline
};

// Throws until they are content or tired, then moves on to the button that ends it, 2.5 s of hovering.
// shown_mm: the outline on the clay, radius and height from below, for kFollowsOutline.
Visit throw_a_pot(Kind kind, std::uint64_t seed, const Skill& skill, WheelRig& rig,
                  const std::vector<dvec2>& shown_mm = {});

}  // namespace onggi::visitors

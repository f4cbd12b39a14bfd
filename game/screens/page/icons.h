// The icons of the tokens, as strokes in a field of 64 x 64. Any thread; constant.
#pragma once

#include <string>

#include "engine/ui/sketch.h"

namespace onggi::screens {

enum class Icon {
    kUndo,
    kAgain,
    kTool,
    kWater,
    kSpeed,
    kDone,
    kUp,
    kDown,
    kLeft,
    kRight,
    kMinus,
    kPlus,
    kSound,
    kText,
    kHand,
    kRib,
    kSponge,
    kWire,
    kMore,
    kAbout,
    kLow,
    kStill,
    kSpeech,
    kCheck,
    kLookIn,
    kShow,
    kNoWifi,
    kNoCode,
    kStepPress,  // sections of the clay
    kStepOpen,
    kStepRaise,
    kJarFirst,  // a jar of two bowls
    kJarAside,
    kJarSecond,
    kJarJoin,
    kJarWhole,
    kTrimmer,
    kFingerWaves,  // ways of decorating
    kIronBrush,
    kBlueBrush,
    kInlay,
    kWhiteBrush,
    kFlower,
    kTurns,
    kRests,
    kWipe,
    kPale,
    kDark,
    kBrushDown,
    kCrane,  // motifs
    kCloud,
    kMum,
    kFish,
    kGrass,
    kWave,
};
constexpr int kIconCount = static_cast<int>(Icon::kWave) + 1;

// Adds the icon in a square of `side` u with its top left at `at`.
void add_icon(ui::Sketch& sketch, Icon icon, vec2 at, float side, const ui::Colour& stroke);
// The same with every fill removed or replaced by one colour, for steps that are done or still to come.
void add_icon(ui::Sketch& sketch, Icon icon, vec2 at, float side, const ui::Colour& stroke,
              const std::optional<ui::Colour>& fill);

// The path of a coil of clay from its middle outwards, up to the fraction, in a square of kSpiralSide; with a
// stroke width of 13 its turns touch.
constexpr float kSpiralSide = 360.0F;
[[nodiscard]] std::string spiral_path(float fraction);

}  // namespace onggi::screens

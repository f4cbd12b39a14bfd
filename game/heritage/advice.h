// Advice on a thrown pot beside a museum's: one good thing, and one to try next. Any thread; pure.
#pragma once

#include <optional>
#include <string>

#include "game/heritage/score.h"

namespace onggi::heritage {

enum class PotPart { kHeight, kBelly, kMouth, kFoot, kWall, kHollow };
constexpr int kPotPartCount = 6;

struct Advice {
    PotPart good = PotPart::kHeight;
    std::optional<PotPart> next{};  // empty: every part is close enough
    bool more = false;              // direction for that part: taller, rounder, wider
};

// fraction: of the museum's size, if the pot was thrown to a size; empty: compares only proportions. A hollow
// that was never opened and a thick wall come before the outline. Never advises a thicker wall. Precondition:
// the pot has a height.
[[nodiscard]] Advice advise(const PotForm& pot, const Target& target, std::optional<double> fraction);

// Keys of the language files: "tip.good.belly", and "tip.next.mouth.more" or "tip.next.other".
[[nodiscard]] std::string good_key(const Advice& advice);
[[nodiscard]] std::string next_key(const Advice& advice);

// The text of `throw --target`, a line each.
[[nodiscard]] std::string report(const Advice& advice);

}  // namespace onggi::heritage

// One thing that is good about a thrown pot beside a museum's, and one to try next. Any thread; pure.
#pragma once

#include <optional>
#include <string>

#include "game/heritage/score.h"

namespace onggi::heritage {

enum class PotPart { kHeight, kBelly, kMouth, kFoot, kWall };
constexpr int kPotPartCount = 5;

struct Advice {
    PotPart good = PotPart::kHeight;
    std::optional<PotPart> next{};  // nothing: all of it is near enough
    bool more = false;              // of that part: taller, rounder, wider
};

// fraction: of the museum's size, where the pot was thrown to be that large; nothing: only their proportions
// are compared. A wall is never advised to be thicker. Precondition: the pot has a height.
[[nodiscard]] Advice advise(const PotForm& pot, const Target& target, std::optional<double> fraction);

// Of the languages: "tip.good.belly", and "tip.next.mouth.more" or "tip.next.other".
[[nodiscard]] std::string good_key(const Advice& advice);
[[nodiscard]] std::string next_key(const Advice& advice);

// What `throw --target` says: a line each.
[[nodiscard]] std::string report(const Advice& advice);

}  // namespace onggi::heritage

#include "game/heritage/advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace onggi::heritage {
namespace {

// A key of the language files, and the text for the command line.
struct Words {
    const char* key = nullptr;
    const char* text = nullptr;
};
struct PartWords {
    Words good;
    Words more;
    Words less;
};
constexpr std::array<PartWords, kPotPartCount> kParts{
    {{.good = {"tip.good.height", "the right height"},
      .more = {"tip.next.height.more", "pull it a little higher"},
      .less = {"tip.next.height.less", "leave it a little lower"}},
     {.good = {"tip.good.belly", "a full, round belly"},
      .more = {"tip.next.belly.more", "a rounder belly"},
      .less = {"tip.next.belly.less", "a slimmer belly"}},
     {.good = {"tip.good.mouth", "a well-sized mouth"},
      .more = {"tip.next.mouth.more", "a wider mouth"},
      .less = {"tip.next.mouth.less", "a closer mouth"}},
     {.good = {"tip.good.foot", "a foot that carries it"},
      .more = {"tip.next.foot.more", "a wider foot"},
      .less = {"tip.next.foot.less", "a smaller foot"}},
     {.good = {"tip.good.wall", "a thin, light wall"},
      .more = {},
      .less = {"tip.next.wall.less", "a thinner wall"}}}};
constexpr Words kOther{"tip.next.other", "another pot of the shelf"};

const Words& good_words(const Advice& advice) {
    return kParts[static_cast<std::size_t>(advice.good)].good;
}

const Words& next_words(const Advice& advice) {
    if (!advice.next) return kOther;
    const PartWords& part = kParts[static_cast<std::size_t>(*advice.next)];
    return advice.more ? part.more : part.less;
}

// Relative deviation of a part from the museum's pot.
struct Off {
    PotPart part;
    double by;
};

bool has_belly(const PotForm& pot) {
    constexpr double kBeyond = 1.05;
    return pot.widest_mm() > kBeyond * std::max(pot.mouth_mm(), pot.foot_mm());
}

// Ratio of the widest diameter to the mean of mouth and foot: 1 for a straight wall.
double fullness(const PotForm& pot) {
    return 2.0 * pot.widest_mm() / (pot.mouth_mm() + pot.foot_mm());
}

}  // namespace

Advice advise(const PotForm& pot, const Target& target, std::optional<double> fraction) {
    constexpr double kNearEnough = 0.06;
    constexpr double kThinWallMm =
        6.0;  // fired; the wall that a practised hand leaves in a pot from a lump of this size
    constexpr double kOfWall = 0.25;  // a wall of twice the thickness counts as a diameter off by a quarter
    constexpr double kAlike = 0.02;
    const PotForm museum = form_of(target);
    const double scale = fraction.value_or(pot.height_mm / museum.height_mm);
    std::array<Off, kPotPartCount> parts{
        {{PotPart::kHeight, pot.height_mm / (scale * museum.height_mm) - 1.0},
         {PotPart::kBelly, fullness(pot) / fullness(museum) - 1.0},
         {PotPart::kMouth, pot.mouth_mm() / (scale * museum.mouth_mm()) - 1.0},
         {PotPart::kFoot, pot.foot_mm() / (scale * museum.foot_mm()) - 1.0},
         {PotPart::kWall, kOfWall * std::max(0.0, pot.wall_mm.value_or(0.0) / kThinWallMm - 1.0)}}};
    const auto is_asked = [&](const Off& off) {
        if (off.part == PotPart::kHeight) return fraction.has_value();
        if (off.part == PotPart::kBelly) return has_belly(museum);
        if (off.part == PotPart::kFoot) return true;
        return pot.wall_mm.has_value();  // a solid lump has neither wall nor mouth
    };
    const auto end = std::stable_partition(parts.begin(), parts.end(), is_asked);
    const auto [nearest, farthest] = std::minmax_element(
        parts.begin(), end,
        [](const Off& one, const Off& other) { return std::fabs(one.by) < std::fabs(other.by); });
    Advice advice{.good = nearest->part};
    if (std::fabs(farthest->by) < kNearEnough) return advice;
    // If all parts deviate alike, the advice is about size: the height, the first part.
    const bool is_size = std::fabs(parts.front().by) > std::fabs(farthest->by) - kAlike;
    const Off& next = is_size ? parts.front() : *farthest;
    advice.next = next.part;
    advice.more = next.by < 0.0;
    return advice;
}

std::string good_key(const Advice& advice) {
    return good_words(advice).key;
}

std::string next_key(const Advice& advice) {
    return next_words(advice).key;
}

std::string report(const Advice& advice) {
    return fmt::format("  good         {}\n  try next     {}\n", good_words(advice).text,
                       next_words(advice).text);
}

}  // namespace onggi::heritage

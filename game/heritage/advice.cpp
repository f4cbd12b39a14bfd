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
      .less = {"tip.next.wall.less", "a thinner wall"}},
     {.good = {}, .more = {"tip.next.hollow", "open the middle"}, .less = {}}}};
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

// How far the widest diameter exceeds the mean of mouth and foot: 0 for a straight wall.
double bulge_mm(const PotForm& pot) {
    return pot.widest_mm() - 0.5 * (pot.mouth_mm() + pot.foot_mm());
}

// The mean wall across its lean, which is less than its width in a level cut; 0 for a solid pot.
double wall_across_mm(const PotForm& pot) {
    const double step_mm = pot.height_mm / static_cast<double>(pot.radii_mm.size() - 1);
    double length_mm = 0.0;
    for (std::size_t i = 0; i + 1 < pot.radii_mm.size(); ++i)
        length_mm += std::hypot(step_mm, pot.radii_mm[i + 1] - pot.radii_mm[i]);
    return pot.wall_mm.value_or(0.0) * pot.height_mm / length_mm;
}

}  // namespace

Advice advise(const PotForm& pot, const Target& target, std::optional<double> fraction) {
    constexpr double kNearEnough = 0.06;
    constexpr double kThinWallMm =
        6.0;  // fired; the wall that a practised hand leaves in a pot from a lump of this size
    constexpr double kOfWall = 0.25;  // a wall of twice the thickness counts as a diameter off by a quarter
    constexpr double kAlike = 0.02;
    constexpr double kThickWallMm = 9.0;  // likewise; thicker, and the outline is not yet what matters
    const double wall_mm = wall_across_mm(pot);
    const PotForm museum = form_of(target);
    const double scale = fraction.value_or(pot.height_mm / museum.height_mm);
    // In widths of the whole pot, as the eye compares: a small foot is no more important than a wide mouth.
    const auto off_by = [&](double pot_mm, double museum_mm) {
        return (pot_mm - scale * museum_mm) / (scale * museum.widest_mm());
    };
    std::array<Off, 5> parts{{{PotPart::kHeight, pot.height_mm / (scale * museum.height_mm) - 1.0},
                              {PotPart::kBelly, off_by(bulge_mm(pot), bulge_mm(museum))},
                              {PotPart::kMouth, off_by(pot.mouth_mm(), museum.mouth_mm())},
                              {PotPart::kFoot, off_by(pot.foot_mm(), museum.foot_mm())},
                              {PotPart::kWall, kOfWall * std::max(0.0, wall_mm / kThinWallMm - 1.0)}}};
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
    if (!pot.wall_mm) return {.good = nearest->part, .next = PotPart::kHollow, .more = true};
    if (wall_mm > kThickWallMm) return {.good = nearest->part, .next = PotPart::kWall};
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

#include "game/decoration/stroke.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace onggi::decoration {
namespace {

bool is_among(int number, int least, int most) {
    return number >= least && number <= most;
}

}  // namespace

Result<StrokePoint> stroke_point(double turns, double height_mm, double pressure) {
    constexpr double kMostHeightMm = 65535.0 / kHeightUnitsPerMm;
    if (!std::isfinite(turns) || !std::isfinite(height_mm) || !std::isfinite(pressure)) {
        return bad_input(fmt::format("stroke: expected a point of numbers, found ({}, {} mm, {})", turns,
                                     height_mm, pressure));
    }
    if (height_mm < 0.0 || height_mm > kMostHeightMm) {
        return bad_input(
            fmt::format("stroke: expected a height of 0 to {} mm, found {}", kMostHeightMm, height_mm));
    }
    const double own = turns - std::floor(turns);
    constexpr double kMostPressure = 255.0;
    return StrokePoint{
        .turn = static_cast<std::uint16_t>(static_cast<std::uint32_t>(own * kTurnUnits + 0.5) & 0xffffU),
        .height = static_cast<std::uint16_t>(std::min(height_mm * kHeightUnitsPerMm + 0.5, 65535.0)),
        .pressure = static_cast<std::uint8_t>(std::clamp(pressure, 0.0, 1.0) * kMostPressure + 0.5)};
}

Result<void> check_stroke(const Stroke& stroke, const std::string& name) {
    const auto wrong = [&](const std::string& expected, auto found) {
        return bad_input(fmt::format("{}: expected {}, found {}", name, expected, found));
    };
    const auto technique = static_cast<int>(stroke.technique);
    if (!is_among(technique, 1, kTechniqueCount))
        return wrong(fmt::format("a technique of 1 to {}", kTechniqueCount), technique);
    if (!is_among(static_cast<int>(stroke.slip), 0, kSlipCount - 1))
        return wrong("a slip of 0 or 1", static_cast<int>(stroke.slip));
    const bool is_motif = stroke.technique == Technique::kMotif;
    const auto motif = static_cast<int>(stroke.motif);
    if (is_motif ? !is_among(motif, 1, kMotifCount - 1) : motif != 0)
        return wrong(is_motif ? fmt::format("a motif of 1 to {}", kMotifCount - 1) : "no motif", motif);
    if (!is_among(stroke.repeats, 1, is_motif ? kMostRepeats : 1))
        return wrong(fmt::format("1 to {} repeats", is_motif ? kMostRepeats : 1), int{stroke.repeats});
    if (!is_among(stroke.width, kLeastWidth, kMostWidth))
        return wrong(fmt::format("a width of {} to {} hundredths of a mm", kLeastWidth, kMostWidth),
                     stroke.width);
    const std::size_t most = is_motif ? 1 : stroke.technique == Technique::kClear ? 0 : kMostPointsOfStroke;
    const std::size_t least = is_motif ? 1 : 0;
    if (stroke.points.size() < least || stroke.points.size() > most)
        return wrong(fmt::format("{} to {} points", least, most), stroke.points.size());
    return {};
}

}  // namespace onggi::decoration

#include "game/decoration/stroke.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/little_endian.h"

namespace onggi::decoration {
namespace {

bool is_among(int number, int least, int most) {
    return number >= least && number <= most;
}

using little_endian::get;
using little_endian::put;

constexpr std::uint16_t kVersion = 1;
constexpr std::size_t kHeadBytes = 12;
constexpr std::size_t kStrokeBytes = 8;
constexpr std::size_t kPointBytes = 5;

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

std::vector<std::byte> bytes_of(const Recorded& recorded) {
    std::vector<std::byte> bytes;
    put(bytes, kVersion);
    put(bytes, static_cast<std::uint16_t>(recorded.strokes.size()));
    put(bytes, recorded.texture_hash);
    for (const Stroke& stroke : recorded.strokes) {
        put(bytes, static_cast<std::uint8_t>(stroke.technique));
        put(bytes, static_cast<std::uint8_t>(stroke.slip));
        put(bytes, static_cast<std::uint8_t>(stroke.motif));
        put(bytes, stroke.repeats);
        put(bytes, stroke.width);
        put(bytes, static_cast<std::uint16_t>(stroke.points.size()));
        for (const StrokePoint& point : stroke.points) {
            put(bytes, point.turn);
            put(bytes, point.height);
            put(bytes, point.pressure);
        }
    }
    return bytes;
}

Result<Recorded> recorded_from(std::span<const std::byte> bytes, const std::string& name) {
    std::size_t at = 0;
    const auto place = [&] { return fmt::format("{}: decoration byte {}", name, at); };
    const auto has = [&](std::size_t count) { return bytes.size() - at >= count; };
    const auto cut = [&](const char* what) {
        return bad_input(
            fmt::format("{}: expected {}, found the end after {} bytes", place(), what, bytes.size() - at));
    };
    const auto number = [&]<typename T>(T) {
        const T value = get<T>(bytes.data() + at);
        at += sizeof(T);
        return value;
    };
    if (!has(kHeadBytes)) return cut("a head");
    if (const auto version = get<std::uint16_t>(bytes.data()); version != kVersion)
        return bad_input(fmt::format("{}: expected version {}, found {}", place(), kVersion, version));
    at += sizeof kVersion;
    const std::size_t count = get<std::uint16_t>(bytes.data() + at);
    if (count > kMostStrokes)
        return bad_input(
            fmt::format("{}: expected at most {} strokes, found {}", place(), kMostStrokes, count));
    at += sizeof(std::uint16_t);
    Recorded recorded;
    recorded.texture_hash = number(std::uint64_t{});
    std::size_t points = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (!has(kStrokeBytes)) return cut("a stroke");
        const std::string where = fmt::format("{}: stroke {}", place(), i + 1);
        Stroke stroke;
        stroke.technique = static_cast<Technique>(number(std::uint8_t{}));
        stroke.slip = static_cast<Slip>(number(std::uint8_t{}));
        stroke.motif = static_cast<Motif>(number(std::uint8_t{}));
        stroke.repeats = number(std::uint8_t{});
        stroke.width = number(std::uint16_t{});
        const std::size_t own = number(std::uint16_t{});
        points += own;
        if (own > kMostPointsOfStroke || points > kMostPoints)
            return bad_input(fmt::format("{}: expected at most {} points and {} in all, found {} and {}",
                                         where, kMostPointsOfStroke, kMostPoints, own, points));
        if (!has(own * kPointBytes)) return cut("a stroke's points");
        stroke.points.reserve(own);
        for (std::size_t k = 0; k < own; ++k) {
            StrokePoint point;
            point.turn = number(std::uint16_t{});
            point.height = number(std::uint16_t{});
            point.pressure = number(std::uint8_t{});
            stroke.points.push_back(point);
        }
        if (auto checked = check_stroke(stroke, where); !checked) return checked.error();
        recorded.strokes.push_back(std::move(stroke));
    }
    if (has(1))
        return bad_input(
            fmt::format("{}: expected the end, found {} bytes more", place(), bytes.size() - at));
    return recorded;
}

}  // namespace onggi::decoration

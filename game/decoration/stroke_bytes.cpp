#include "game/decoration/stroke_bytes.h"

#include <fmt/format.h>

#include "engine/core/little_endian.h"

namespace onggi::decoration {
namespace {

using little_endian::get;
using little_endian::put;

constexpr std::uint16_t kVersion = 1;
constexpr std::size_t kHeadBytes = 12;
constexpr std::size_t kStrokeBytes = 8;
constexpr std::size_t kPointBytes = 5;

}  // namespace

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

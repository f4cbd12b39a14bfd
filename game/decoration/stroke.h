// What a visitor draws on a pot, as values: strokes, as they are recorded and played back to the bit. Places
// are whole numbers, so that a recording gives the same texture on every machine. Any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/core/result.h"

namespace onggi::decoration {

// The numbers are in files: never renumber.
enum class Technique : std::uint8_t {
    kFinger = 1,       // three fingers through the wet coat
    kIron = 2,         // a brush of iron, cheolhwa
    kCobalt = 3,       // a brush of cobalt, cheonghwa
    kInlay = 4,        // a carved line filled with slip and scraped level, sanggam
    kBrushedSlip = 5,  // white slip with a coarse brush, gwiyal
    kMotif = 6,        // one of the motifs, placed at one point
    kClear = 7,        // everything before is wiped off
};
constexpr int kTechniqueCount = 7;

// What an inlaid line is filled with.
enum class Slip : std::uint8_t { kWhite = 0, kBlack = 1 };
constexpr int kSlipCount = 2;

enum class Motif : std::uint8_t {
    kNone = 0,
    kCrane = 1,
    kCloud = 2,
    kChrysanthemum = 3,
    kFish = 4,
    kGrass = 5,
    kWave = 6,
};
constexpr int kMotifCount = 7;  // with none

struct StrokePoint {
    std::uint16_t turn = 0;       // from the pot's direction 0, counter-clockwise from above; 65536 a turn
    std::uint16_t height = 0;     // of the pot as it was drawn on; 64 a mm
    std::uint8_t pressure = 255;  // narrower where it is less

    friend bool operator==(const StrokePoint&, const StrokePoint&) = default;
};
constexpr double kTurnUnits = 65536.0;
constexpr double kHeightUnitsPerMm = 64.0;

struct Stroke {
    Technique technique = Technique::kIron;
    Slip slip = Slip::kWhite;           // of an inlay
    Motif motif = Motif::kNone;         // of a motif
    std::uint8_t repeats = 1;           // of a motif, evenly round the pot
    std::uint16_t width = 450;          // of the stroke, or the height of a motif; 100 a mm
    std::vector<StrokePoint> points{};  // one of a motif, none of a clearing

    friend bool operator==(const Stroke&, const Stroke&) = default;
};
constexpr double kWidthUnitsPerMm = 100.0;

using Strokes = std::vector<Stroke>;

constexpr std::size_t kMostStrokes = 512;
constexpr std::size_t kMostPointsOfStroke = 4096;
constexpr std::size_t kMostPoints = 65536;  // of all strokes together
constexpr std::uint16_t kLeastWidth = 50;
constexpr std::uint16_t kMostWidth = 20000;
constexpr std::uint8_t kMostRepeats = 12;

// The nearest point that can be recorded: `turns` round the pot (any number of them), so high above the foot.
// Bad input: a number that is none, or a height that cannot be recorded.
[[nodiscard]] Result<StrokePoint> stroke_point(double turns, double height_mm, double pressure = 1.0);

// Bad input where a stroke is none that may be recorded. `name` stands before the message.
[[nodiscard]] Result<void> check_stroke(const Stroke& stroke, const std::string& name);

// Strokes as bytes, for session files; README.md gives the layout. Any thread.

// What a session says of a pot's decoration.
struct Recorded {
    Strokes strokes{};
    std::uint64_t texture_hash = 0;  // of what they came to, see Texture::hash()

    friend bool operator==(const Recorded&, const Recorded&) = default;
};

[[nodiscard]] std::vector<std::byte> bytes_of(const Recorded& recorded);

// Bad input: another version, a number out of its bounds, too few or too many bytes. `name` stands for where
// they come from in the message, which names the byte.
[[nodiscard]] Result<Recorded> recorded_from(std::span<const std::byte> bytes, const std::string& name);

}  // namespace onggi::decoration

// Strokes that a visitor draws on a pot, as values that are recorded and played back to the bit. Places are
// integers, so that a recording leads to the same texture on every machine. Any thread.
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
    kMotif = 6,        // one of the motifs, placed at a point
    kClear = 7,        // wipes off everything before
};
constexpr int kTechniqueCount = 7;

// The filling of an inlaid line.
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
constexpr int kMotifCount = 7;  // including kNone

struct StrokePoint {
    std::uint16_t turn = 0;       // from the pot's direction 0, counter-clockwise from above; 65536 a turn
    std::uint16_t height = 0;     // of the pot when it was drawn on; 64 a mm
    std::uint8_t pressure = 255;  // lower pressure, narrower line

    friend bool operator==(const StrokePoint&, const StrokePoint&) = default;
};
constexpr double kTurnUnits = 65536.0;
constexpr double kHeightUnitsPerMm = 64.0;

struct Stroke {
    Technique technique = Technique::kIron;
    Slip slip = Slip::kWhite;           // for an inlay
    Motif motif = Motif::kNone;         // for a motif
    std::uint8_t repeats = 1;           // for a motif: copies evenly round the pot
    std::uint16_t width = 450;          // of the stroke; for a motif its height; 100 a mm
    std::vector<StrokePoint> points{};  // one for a motif, none for kClear

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

// The nearest point that can be recorded, `turns` round the pot (any number) and height_mm above the foot.
// Bad input: a number that is not finite, or a height that cannot be recorded.
[[nodiscard]] Result<StrokePoint> stroke_point(double turns, double height_mm, double pressure = 1.0);

// Bad input if the stroke may not be recorded. `name` starts the message.
[[nodiscard]] Result<void> check_stroke(const Stroke& stroke, const std::string& name);

// Strokes as bytes, for session files; README.md describes the layout. Any thread.

// A pot's decoration in a session.
struct Recorded {
    Strokes strokes{};
    std::uint64_t texture_hash = 0;  // of the resulting texture, see Texture::hash()

    friend bool operator==(const Recorded&, const Recorded&) = default;
};

[[nodiscard]] std::vector<std::byte> bytes_of(const Recorded& recorded);

// Bad input: another version, a number out of its bounds, too few or too many bytes. `name` is the source of
// the bytes in the message, which also has the byte's position.
[[nodiscard]] Result<Recorded> recorded_from(std::span<const std::byte> bytes, const std::string& name);

}  // namespace onggi::decoration

// The result of the strokes on a pot: one texture of its outer wall, evenly spaced round it and up its
// height. Any thread; plain data.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/hash.h"

namespace onggi::decoration {

constexpr int kColumns = 1024;  // once round, from the pot's direction 0, counter-clockwise from above
constexpr int kRows = 512;      // from foot to rim

enum class Pigment : std::uint8_t { kNone = 0, kWhiteSlip = 1, kBlackSlip = 2, kIron = 3, kCobalt = 4 };
constexpr int kPigmentCount = 5;  // including kNone

// Four bytes, in the order of red, green, blue and alpha.
struct Texel {
    static constexpr std::uint8_t kLevel = 128;
    static constexpr std::uint8_t kWiped = 128;

    Pigment pigment = Pigment::kNone;
    std::uint8_t amount = 0;       // amount of pigment; 255 is opaque
    std::uint8_t relief = kLevel;  // of the wall: 1 is 0.4 mm deep, 255 is 0.4 mm high
    // The coat of wet slip or glaze that fingers wipe through: 0 without one; kWiped to 255, from wiped off
    // to full thickness.
    std::uint8_t coat = 0;

    friend bool operator==(const Texel&, const Texel&) = default;
};
static_assert(sizeof(Texel) == 4);
constexpr float kReliefMmPerStep = 0.4F / 127.0F;

struct Texture {
    std::vector<Texel> texels = std::vector<Texel>(std::size_t{kColumns} * kRows);

    [[nodiscard]] Texel& at(int column, int row) {
        return texels[static_cast<std::size_t>(row) * kColumns + static_cast<std::size_t>(column)];
    }
    [[nodiscard]] const Texel& at(int column, int row) const {
        return texels[static_cast<std::size_t>(row) * kColumns + static_cast<std::size_t>(column)];
    }
    [[nodiscard]] std::uint64_t hash() const {
        StateHash hash;
        hash.add_bytes(std::as_bytes(std::span(texels)));
        return hash.value();
    }
    friend bool operator==(const Texture&, const Texture&) = default;
};

// The texel of a place: `turns` round the pot, and a fraction of its height.
[[nodiscard]] inline int column_at(float turns) {
    return static_cast<int>((turns - std::floor(turns)) * kColumns) & (kColumns - 1);
}
[[nodiscard]] inline int row_at(float fraction) {
    return std::clamp(static_cast<int>(fraction * kRows), 0, kRows - 1);
}

// A part of the texture; columns may run over the seam.
struct TextureRect {
    int row = 0;
    int row_count = 0;
    int column = 0;
    int column_count = 0;

    [[nodiscard]] bool empty() const { return row_count == 0 || column_count == 0; }
    // Grows to the bounding rectangle of both.
    void add(const TextureRect& other);
    [[nodiscard]] static TextureRect all() { return {0, kRows, 0, kColumns}; }
};

}  // namespace onggi::decoration

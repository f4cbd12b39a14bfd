#include "game/decoration/ink.h"

#include <algorithm>

#include "engine/math/lattice.h"
#include "engine/math/math.h"

namespace onggi::decoration {
namespace {

// Smooth noise, 0 to 1, with cells_round cells round the pot, periodic, and one cell every rows_a_cell rows.
float grain(int column, int row, int cells_round, float rows_a_cell) {
    const float x =
        (static_cast<float>(column) + 0.5F) * static_cast<float>(cells_round) / static_cast<float>(kColumns);
    const float y = static_cast<float>(row) / rows_a_cell;
    const int left = static_cast<int>(x);
    const int low = static_cast<int>(y);
    const int right = (left + 1) % cells_round;
    const float u = glm::smoothstep(0.0F, 1.0F, x - static_cast<float>(left));
    const float v = glm::smoothstep(0.0F, 1.0F, y - static_cast<float>(low));
    const float below = lattice(left, low) + u * (lattice(right, low) - lattice(left, low));
    const float above = lattice(left, low + 1) + u * (lattice(right, low + 1) - lattice(left, low + 1));
    return below + v * (above - below);
}

std::uint8_t part_of(int whole, int cover) {
    return static_cast<std::uint8_t>((whole * cover + 127) / 255);
}

// Paints over the texel: the amounts add up, and the larger amount sets the colour.
Texel pigmented(Texel texel, Pigment pigment, std::uint8_t amount) {
    const int left = part_of(texel.amount, 255 - amount);
    if (amount > 0 && amount >= left) texel.pigment = pigment;
    texel.amount = static_cast<std::uint8_t>(std::min(255, left + amount));
    return texel;
}

// The amount that a brush lays at this texel, 0 to 255.
int density(Ink ink, int column, int row) {
    switch (ink) {
        case Ink::kIron: {
            constexpr float kLeast = 200.0F;
            return static_cast<int>(kLeast + 55.0F * grain(column, row, 72, 15.0F));
        }
        case Ink::kCobalt: {
            constexpr float kLeast = 175.0F;
            return static_cast<int>(kLeast + 80.0F * grain(column, row, 56, 21.0F));
        }
        case Ink::kBrushedSlip: {
            // Hairs of a coarse brush that moves round the pot.
            const float hairs = 0.65F * grain(column, row, 14, 3.4F) + 0.35F * grain(column, row, 40, 1.6F);
            return static_cast<int>(255.0F * std::clamp((hairs - 0.22F) / 0.24F, 0.12F, 1.0F));
        }
        case Ink::kWipe:
        case Ink::kWhiteInlay:
        case Ink::kBlackInlay:
            break;
    }
    return 255;
}

Pigment pigment_of(Ink ink) {
    switch (ink) {
        case Ink::kIron:
            return Pigment::kIron;
        case Ink::kCobalt:
            return Pigment::kCobalt;
        case Ink::kWhiteInlay:
        case Ink::kBrushedSlip:
            return Pigment::kWhiteSlip;
        case Ink::kBlackInlay:
            return Pigment::kBlackSlip;
        case Ink::kWipe:
            break;
    }
    return Pigment::kNone;
}

}  // namespace

Ink ink_of(Technique technique, Slip slip) {
    switch (technique) {
        case Technique::kFinger:
            return Ink::kWipe;
        case Technique::kCobalt:
            return Ink::kCobalt;
        case Technique::kInlay:
            return slip == Slip::kBlack ? Ink::kBlackInlay : Ink::kWhiteInlay;
        case Technique::kBrushedSlip:
            return Ink::kBrushedSlip;
        case Technique::kIron:
        case Technique::kMotif:
        case Technique::kClear:
            break;
    }
    return Ink::kIron;
}

Texel inked(const Texel& under, Ink ink, std::uint8_t cover, int column, int row) {
    if (cover == 0) return under;
    if (ink == Ink::kWipe) {
        Texel texel = under;
        constexpr int kDeepest = 96;
        const int rest = 255 - cover;
        texel.amount = part_of(under.amount, rest);
        if (texel.amount == 0) texel.pigment = Pigment::kNone;
        if (under.coat > Texel::kWiped)
            texel.coat = static_cast<std::uint8_t>(Texel::kWiped + part_of(under.coat - Texel::kWiped, rest));
        texel.relief = static_cast<std::uint8_t>(std::max(1, under.relief - part_of(kDeepest, cover)));
        return texel;
    }
    return pigmented(under, pigment_of(ink), part_of(density(ink, column, row), cover));
}

Texel coated(const Texel& under, int column, int row) {
    // The coat of a dipped or poured pot: leaves out foot and neck, with slightly wavy edges.
    constexpr float kLow = 0.17F * kRows;
    constexpr float kHigh = 0.86F * kRows;
    constexpr float kEdgeRows = 3.0F;
    constexpr float kEdge = 0.55F;  // the coat ends in a lip instead of fading out
    if (under.coat != 0) return under;
    const float wave = 5.0F * (grain(column, 0, 18, 1.0F) - 0.5F);
    const float off = std::min(static_cast<float>(row) - kLow - wave, kHigh + wave - static_cast<float>(row));
    if (off <= 0.0F) return under;
    Texel texel = under;
    constexpr float kThickness = 255.0F - Texel::kWiped;
    const float thick = std::min(1.0F, kEdge + off / kEdgeRows);
    texel.coat = static_cast<std::uint8_t>(Texel::kWiped + thick * kThickness);
    return texel;
}

}  // namespace onggi::decoration

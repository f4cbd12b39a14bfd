#include "game/finish/mark_colour.h"

#include <algorithm>

namespace onggi::finish {

using decoration::Pigment;
using decoration::Texel;

vec3 pigment_colour(const MarkPalette& palette, Pigment pigment) {
    switch (pigment) {
        case Pigment::kWhiteSlip:
            return palette.white_slip;
        case Pigment::kBlackSlip:
            return palette.black_slip;
        case Pigment::kCobalt:
            return palette.cobalt;
        case Pigment::kIron:
        case Pigment::kNone:
            break;
    }
    return palette.iron;
}

MarkColour mark_colour(const MarkPalette& palette, const Texel& texel) {
    constexpr float kMost = 255.0F;
    const float amount = static_cast<float>(texel.amount) / kMost;
    const vec3 pigment = pigment_colour(palette, texel.pigment);
    if (texel.coat == 0) return {pigment, amount};
    const float thick = static_cast<float>(std::max(0, texel.coat - Texel::kWiped)) / (kMost - Texel::kWiped);
    const vec3 coat = glm::mix(palette.finger, palette.coat, thick);
    return {glm::mix(coat, pigment, amount), 1.0F};
}

vec2 relief_lean(const decoration::Texture& texture, const decoration::Wall& wall, int column, int row) {
    using decoration::kColumns;
    using decoration::kRows;
    const auto relief = [&](int at_column, int at_row) {
        return static_cast<float>(texture.at(at_column & (kColumns - 1), at_row).relief);
    };
    const int below = std::max(row - 1, 0);
    const int above = std::min(row + 1, kRows - 1);
    const float round_mm = 2.0F * wall.round_mm[static_cast<std::size_t>(row)] / kColumns;
    const float up_mm =
        wall.along_mm[static_cast<std::size_t>(above)] - wall.along_mm[static_cast<std::size_t>(below)];
    return -decoration::kReliefMmPerStep *
           vec2((relief(column + 1, row) - relief(column - 1, row)) / round_mm,
                (relief(column, above) - relief(column, below)) / up_mm);
}

}  // namespace onggi::finish

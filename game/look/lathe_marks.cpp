#include "game/look/lathe_marks.h"

#include <algorithm>
#include <cmath>

#include "engine/core/hash.h"
#include "game/finish/mark_colour.h"

namespace onggi::look {

using decoration::kColumns;
using decoration::kRows;
static_assert(kColumns == render::kMarkColumns && kRows == render::kMarkRows);

namespace {

std::uint32_t rounded(float number) {
    constexpr float kMost = 255.0F;
    return static_cast<std::uint32_t>(std::clamp(number, 0.0F, kMost) + 0.5F);
}

std::uint32_t colour_word(const finish::MarkColour& mark) {
    constexpr float kByte = 255.0F;
    std::uint32_t word = 0;
    for (int channel = 0; channel < 3; ++channel)
        word |= rounded(kByte * std::sqrt(std::max(mark.colour[channel], 0.0F))) << (8 * channel);
    return word | rounded(kByte * mark.cover) << 24U;
}

std::uint32_t lean_word(const vec2& lean) {
    constexpr float kStep = 127.0F / render::kMarkLean;
    constexpr float kNone = 128.0F;
    return rounded(kNone + kStep * lean.x) | rounded(kNone + kStep * lean.y) << 8U;
}

}  // namespace

void DressedMarks::dress(const decoration::Texture& texture, const decoration::Wall& wall,
                         const finish::MarkPalette& palette) {
    dress_changed(texture, wall, palette, decoration::TextureRect::all());
}

void DressedMarks::dress_changed(const decoration::Texture& texture, const decoration::Wall& wall,
                                 const finish::MarkPalette& palette, const decoration::TextureRect& changed) {
    if (changed.empty()) return;
    marks_.texels.resize(texture.texels.size());
    // Hashes the old revision and the new content, so that different marks have different revisions.
    StateHash revision;
    revision.add_word(marks_.revision);
    // Relief also changes the lean of its neighbours.
    const int from = std::max(changed.row - 1, 0);
    const int end = std::min(changed.row + changed.row_count + 1, kRows);
    const int count = std::min(changed.column_count + 2, kColumns);
    for (int row = from; row < end; ++row) {
        for (int i = 0; i < count; ++i) {
            const int column = (changed.column - 1 + i) & (kColumns - 1);
            const auto at = static_cast<std::size_t>(row) * kColumns + static_cast<std::size_t>(column);
            marks_.texels[at] = {colour_word(finish::mark_colour(palette, texture.texels[at])),
                                 lean_word(finish::relief_lean(texture, wall, column, row))};
            revision.add_word(std::uint64_t{marks_.texels[at].colour} << 32U | marks_.texels[at].lean);
            revision.add_word(at);
        }
    }
    marks_.revision = revision.value();
}

render::LatheMaterial glazed_lathe(const render::LatheMaterial& body, const finish::GlazeMaterial& glaze) {
    render::LatheMaterial material = body;
    material.albedo = glaze.colour;
    material.roughness = glaze.roughness;
    material.coat = glaze.clear_coat;
    material.coat_roughness = glaze.coat_roughness;
    return material;
}

}  // namespace onggi::look

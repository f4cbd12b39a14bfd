#include "game/decoration/stroke_mask.h"

#include <algorithm>
#include <cmath>

namespace onggi::decoration {
namespace {

// Cover, 0 to 1, at off_mm from the middle of a trace. soft_mm: width of a brush's soft edge.
float cover_at(Tip tip, float off_mm, float half_mm, float soft_mm) {
    if (tip == Tip::kBrush) return std::clamp((half_mm - off_mm) / soft_mm + 0.5F, 0.0F, 1.0F);
    if (off_mm >= half_mm) return 0.0F;
    const float place = off_mm / half_mm;
    return std::min(1.6F * (1.0F - place * place), 1.0F);
}

}  // namespace

void TextureRect::add(const TextureRect& other) {
    if (other.empty()) return;
    if (empty()) {
        *this = other;
        return;
    }
    const int end = std::max(row + row_count, other.row + other.row_count);
    row = std::min(row, other.row);
    row_count = end - row;
    // Shift the columns by whole turns to the nearer side.
    int first = other.column;
    while (first - column > kColumns / 2)
        first -= kColumns;
    while (column - first > kColumns / 2)
        first += kColumns;
    const int column_end = std::max(column + column_count, first + other.column_count);
    column = std::min(column, first);
    column_count = std::min(column_end - column, kColumns);
}

TextureRect StrokeMask::lay(const Piece& piece, Tip tip, const Wall& wall) {
    constexpr float kLeastSoftMm = 0.3F;
    constexpr float kSoftTexels = 0.8F;
    const float most_half = std::max(piece.half_mm, piece.end_half_mm);
    const float reach_mm = most_half + 1.0F;
    const float low_mm = std::min(piece.along_mm, piece.end_along_mm) - reach_mm;
    const float high_mm = std::max(piece.along_mm, piece.end_along_mm) + reach_mm;
    TextureRect changed;
    const int first_row = wall.row_from_along(low_mm);
    for (int row = first_row; row < kRows && wall.along_mm[static_cast<std::size_t>(row)] <= high_mm; ++row) {
        const auto at_row = static_cast<std::size_t>(row);
        const float round_mm = wall.round_mm[at_row];
        const float reach = reach_mm / round_mm;
        const float left = std::min(piece.turns, piece.turns + piece.turns_on) - reach;
        const float right = std::max(piece.turns, piece.turns + piece.turns_on) + reach;
        const int first = static_cast<int>(std::floor(left * kColumns));
        const int count = std::min(static_cast<int>(std::floor(right * kColumns)) - first + 1, kColumns);
        const float up = wall.along_mm[at_row] - piece.along_mm;
        const float way_x = piece.turns_on * round_mm;
        const float way_y = piece.end_along_mm - piece.along_mm;
        const float length2 = way_x * way_x + way_y * way_y;
        const float soft = std::max(kLeastSoftMm, kSoftTexels * round_mm / kColumns);
        for (int i = 0; i < count; ++i) {
            const int column = first + i;
            const float x =
                ((static_cast<float>(column) + 0.5F) * (1.0F / kColumns) - piece.turns) * round_mm;
            const float part =
                length2 > 0.0F ? std::clamp((x * way_x + up * way_y) / length2, 0.0F, 1.0F) : 0.0F;
            const float off_x = x - part * way_x;
            const float off_y = up - part * way_y;
            const float off = std::sqrt(off_x * off_x + off_y * off_y);
            const float half = piece.half_mm + part * (piece.end_half_mm - piece.half_mm);
            const auto cover = static_cast<std::uint8_t>(255.0F * cover_at(tip, off, half, soft) + 0.5F);
            std::uint8_t& own =
                covers_[at_row * kColumns + static_cast<std::size_t>(column & (kColumns - 1))];
            own = std::max(own, cover);
        }
        changed.add({row, 1, first, count});
    }
    extent_.add(changed);
    return changed;
}

void StrokeMask::clear() {
    for (int row = extent_.row; row < extent_.row + extent_.row_count; ++row) {
        const auto first = covers_.begin() + static_cast<std::ptrdiff_t>(row) * kColumns;
        std::fill(first, first + kColumns, std::uint8_t{0});
    }
    extent_ = {};
}

}  // namespace onggi::decoration

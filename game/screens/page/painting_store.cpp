#include <algorithm>
#include <array>
#include <cstddef>

#include "engine/core/hash.h"
#include "game/screens/page/page.h"

namespace onggi::screens {
namespace {

// Compositions a painting may sit out: a panel is opened and closed again without painting all anew.
constexpr int kPatience = 24;
// And how much of them may, the newest first: a screen with a pot that turns, but not all of a visit's.
constexpr std::size_t kMostUnusedBytes = std::size_t{6} << 20U;

std::size_t bytes_of(const ui::Painting& painting) {
    return painting.rgba.size();
}

std::size_t bytes_of(const PotPicture& picture) {
    return picture.painting.rgba.size();
}

std::size_t bytes_of(const TurningPot& pot) {
    return pot.bytes();
}

const std::shared_ptr<const ui::Painting>& nothing() {
    static const auto empty = std::make_shared<const ui::Painting>();
    return empty;
}

std::uint64_t key_of(const pot::Section& shape, const finish::GlazeMaterial& glaze, float px_per_mm,
                     float elevation_rad) {
    StateHash hash;
    hash.add_word(shape.hash());
    for (const char letter : glaze.id)
        hash.add_word(static_cast<std::uint64_t>(letter));
    hash.add(double{px_per_mm});
    hash.add(double{elevation_rad});
    return hash.value();
}

}  // namespace

std::shared_ptr<const ui::Painting> PaintingStore::get(const ui::Sketch& sketch, std::uint64_t& key) {
    if (paints_ == Paints::kNothing) return nothing();
    key = std::max<std::uint64_t>(1, sketch.hash());
    Kept<ui::Painting>& kept = paintings_[key];
    if (!kept.value) kept.value = std::make_shared<const ui::Painting>(painter_.paint(sketch));
    kept.unused = 0;
    return kept.value;
}

std::shared_ptr<const PotPicture> PaintingStore::pot(const pot::Section& shape,
                                                     const finish::GlazeMaterial& glaze, float px_per_mm,
                                                     float elevation_rad) {
    if (paints_ == Paints::kNothing) return std::make_shared<const PotPicture>();
    Kept<PotPicture>& kept = pots_[key_of(shape, glaze, px_per_mm, elevation_rad)];
    if (!kept.value)
        kept.value = std::make_shared<const PotPicture>(paint_pot(shape, glaze, px_per_mm, elevation_rad));
    kept.unused = 0;
    return kept.value;
}

std::shared_ptr<const TurningPot> PaintingStore::turning(const pot::Section& shape,
                                                         const finish::GlazeMaterial& glaze, float px_per_mm,
                                                         float elevation_rad, std::uint64_t& key) {
    key = key_of(shape, glaze, px_per_mm, elevation_rad);
    if (paints_ == Paints::kNothing) return nullptr;
    Kept<TurningPot>& kept = turning_[key];
    if (!kept.value) kept.value = std::make_shared<const TurningPot>(shape, glaze, px_per_mm, elevation_rad);
    kept.unused = 0;
    return kept.value;
}

// The bytes of what has sat out that many compositions, by that number.
void PaintingStore::forget_unused() {
    if (paints_ != Paints::kAll) return;
    std::array<std::size_t, kPatience + 1> unused_bytes{};
    const auto look = [&](auto& kept) {
        for (auto& [key, entry] : kept) {
            if (++entry.unused > 1 && entry.unused <= kPatience + 1)
                unused_bytes[static_cast<std::size_t>(entry.unused - 1)] += bytes_of(*entry.value);
        }
    };
    look(paintings_);
    look(pots_);
    look(turning_);
    int most_unused = 1;
    for (std::size_t bytes = 0; most_unused <= kPatience; ++most_unused) {
        bytes += unused_bytes[static_cast<std::size_t>(most_unused)];
        if (bytes > kMostUnusedBytes) break;
    }
    const auto forget = [&](auto& kept) {
        std::erase_if(kept, [&](const auto& entry) { return entry.second.unused > most_unused; });
    };
    forget(paintings_);
    forget(pots_);
    forget(turning_);
}

}  // namespace onggi::screens

#include <algorithm>
#include <iterator>

#include "engine/core/hash.h"
#include "game/screens/page.h"

namespace onggi::screens {
namespace {

// Compositions a painting may sit out: a panel is opened and closed again without painting all anew.
constexpr int kPatience = 24;

const std::shared_ptr<const ui::Painting>& nothing() {
    static const auto empty = std::make_shared<const ui::Painting>();
    return empty;
}

std::uint64_t key_of(const PotShape& shape, const finish::GlazeMaterial& glaze, float px_per_mm,
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

std::shared_ptr<const PotPicture> PaintingStore::pot(const PotShape& shape,
                                                     const finish::GlazeMaterial& glaze, float px_per_mm,
                                                     float elevation_rad) {
    if (paints_ == Paints::kNothing) return std::make_shared<const PotPicture>();
    Kept<PotPicture>& kept = pots_[key_of(shape, glaze, px_per_mm, elevation_rad)];
    if (!kept.value)
        kept.value = std::make_shared<const PotPicture>(paint_pot(shape, glaze, px_per_mm, elevation_rad));
    kept.unused = 0;
    return kept.value;
}

std::shared_ptr<const TurningPot> PaintingStore::turning(const PotShape& shape,
                                                         const finish::GlazeMaterial& glaze, float px_per_mm,
                                                         float elevation_rad, std::uint64_t& key) {
    key = key_of(shape, glaze, px_per_mm, elevation_rad);
    if (paints_ == Paints::kNothing) return nullptr;
    Kept<TurningPot>& kept = turning_[key];
    if (!kept.value) kept.value = std::make_shared<const TurningPot>(shape, glaze, px_per_mm, elevation_rad);
    kept.unused = 0;
    return kept.value;
}

void PaintingStore::forget_unused() {
    const auto forget = [](auto& kept) {
        for (auto entry = kept.begin(); entry != kept.end();) {
            entry = ++entry->second.unused > kPatience ? kept.erase(entry) : std::next(entry);
        }
    };
    forget(paintings_);
    forget(pots_);
    forget(turning_);
}

}  // namespace onggi::screens

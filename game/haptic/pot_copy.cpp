#include "game/haptic/pot_copy.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace onggi::haptic {
namespace {

// Duration of a copy of a studio pot: two a frame at 60 Hz.
constexpr double kCopyS = 1.0 / 120.0;

constexpr std::size_t kDents = static_cast<std::size_t>(kDentRows) * kDentSectors;

// Column by column, so that the loops vectorise. No column grows beyond its capacity.
void copy_rings(pot::Pot& pot, const clay::studio::Rings& rings) noexcept {
    const auto count = static_cast<std::size_t>(rings.count);
    for (auto* column :
         {&pot.outer_mm, &pot.inner_mm, &pot.top_mm, &pot.film, &pot.liquidity, &pot.load_index})
        column->resize(count);
    pot.centre_mm.resize(count);
    const auto narrow = [&](const std::vector<double>& from, std::vector<float>& to) {
        std::transform(from.begin(), from.begin() + rings.count, to.begin(),
                       [](double value) { return static_cast<float>(value); });
    };
    const auto copy = [&](const std::vector<float>& from, std::vector<float>& to) {
        std::copy_n(from.begin(), rings.count, to.begin());
    };
    narrow(rings.outer_mm, pot.outer_mm);
    narrow(rings.inner_mm, pot.inner_mm);
    copy(rings.film, pot.film);
    copy(rings.liquidity, pot.liquidity);
    copy(rings.load_index, pot.load_index);
    for (int i = 0; i < rings.count; ++i) {
        const std::size_t at = clay::studio::Rings::at(i);
        pot.top_mm[at] = static_cast<float>(rings.bottom_mm(i) + rings.height_mm[at]);
        pot.centre_mm[at] = {rings.centre_x_mm[at], rings.centre_z_mm[at]};
    }
}

// Averages the residuals in each sector of the map.
void copy_dent_row(std::span<const float> row, float* out) {
    const std::size_t sectors = row.size();
    for (std::size_t s = 0; s < kDentSectors; ++s) {
        const std::size_t first = s * sectors / kDentSectors;
        const std::size_t end = std::max((s + 1) * sectors / kDentSectors, first + 1);
        float sum = 0.0F;
        for (std::size_t k = first; k < end; ++k)
            sum += row[k];
        out[s] = sum / static_cast<float>(end - first);
    }
}

}  // namespace

bool PotCopier::step(pot::Pot& pot, const HapticState& state, double dt_s) noexcept {
    const clay::StudioClay* studio = state.studio();
    if (studio == nullptr) {
        const clay::PaperClay& paper = *state.paper();
        paper.copy_radii_mm(pot.outer_mm);
        pot.height_mm = paper.height_mm();
        return true;
    }
    // At fast rates the clay's even ticks are the expensive ones (studio_clay.h): the copy uses the odd ones.
    const bool takes_turns = dt_s <= 0.5e-3;
    if (takes_turns && state.ticks % 2 == 0) return false;
    const double part = std::min((takes_turns ? 2.0 : 1.0) * dt_s / kCopyS, 1.0);
    copy_dents(pot, *studio, static_cast<int>(part * kDentRows) + 1);
    if (dent_row_ < kDentRows) return false;
    copy_rings(pot, studio->rings());
    if (!dented_) pot.dents_mm.clear();
    pot.height_mm = studio->height_mm();
    pot.floor_mm = studio->floor_mm();
    pot.body = studio->lump().body;
    restart();
    return true;
}

void PotCopier::copy_dents(pot::Pot& pot, const clay::StudioClay& clay, int most) noexcept {
    pot.dents_mm.resize(kDents);  // the last copy may have cleared it, if that clay was round
    for (int k = 0; k < most && dent_row_ < kDentRows; ++k, ++dent_row_) {
        float* out = pot.dents_mm.data() + static_cast<std::size_t>(dent_row_) * kDentSectors;
        const double y_mm = (dent_row_ + 0.5) / kDentRows * clay.height_mm();
        const auto row =
            clay.ring_count() > 0 ? clay.residuals_mm(clay.rings().ring_at(y_mm)) : std::span<const float>();
        if (row.empty()) {
            std::fill_n(out, kDentSectors, 0.0F);
        } else {
            copy_dent_row(row, out);
            dented_ = true;
        }
    }
}

pot::Pot pot_of(const HapticState& state) {
    pot::Pot pot;
    if (const clay::StudioClay* studio = state.studio()) {
        const auto room = static_cast<std::size_t>(studio->ring_capacity());
        for (auto* column :
             {&pot.outer_mm, &pot.inner_mm, &pot.top_mm, &pot.film, &pot.liquidity, &pot.load_index})
            column->reserve(room);
        pot.centre_mm.reserve(room);
        pot.dents_mm.reserve(kDents);
    } else {
        pot.outer_mm.resize(static_cast<std::size_t>(state.paper()->element_count()));
    }
    PotCopier copier;
    while (!copier.step(pot, state, 1.0)) {
    }
    return pot;
}

}  // namespace onggi::haptic

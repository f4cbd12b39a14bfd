#include "game/haptic/pot_shape.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace onggi::haptic {
namespace {

// How long the copy of a studio pot takes: two a frame at 60 Hz.
constexpr double kCopyS = 1.0 / 120.0;

// Column by column, so that the compiler makes vectors of it.
void copy_rings(PotShape& shape, const clay::studio::Rings& rings) noexcept {
    const auto narrow = [&](const std::vector<double>& from, std::vector<float>& to) {
        std::transform(from.begin(), from.begin() + rings.count, to.begin(),
                       [](double value) { return static_cast<float>(value); });
    };
    const auto copy = [&](const std::vector<float>& from, std::vector<float>& to) {
        std::copy_n(from.begin(), rings.count, to.begin());
    };
    narrow(rings.outer_mm, shape.outer_mm_);
    narrow(rings.inner_mm, shape.inner_mm_);
    copy(rings.film, shape.film_);
    copy(rings.liquidity, shape.liquidity_);
    copy(rings.load_index, shape.load_index_);
    for (int i = 0; i < rings.count; ++i) {
        const std::size_t at = clay::studio::Rings::at(i);
        shape.top_mm_[at] = static_cast<float>(rings.bottom_mm(i) + rings.height_mm[at]);
        shape.centre_mm_[2 * at] = rings.centre_x_mm[at];
        shape.centre_mm_[2 * at + 1] = rings.centre_z_mm[at];
    }
    shape.rings = rings.count;
}

// The mean of the residuals that lie in one sector of the map.
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

bool ShapeCopy::step(PotShape& shape, const HapticState& state, double dt_s) noexcept {
    const clay::StudioClay* studio = state.studio();
    if (studio == nullptr) {
        const clay::PaperClay& paper = *state.paper();
        paper.copy_radii_mm(shape.outer_mm_);
        shape.rings = paper.element_count();
        shape.height_mm = paper.height_mm();
        shape.tick = state.ticks;
        return true;
    }
    // The clay's dearer ticks are the even ones at a fast rate (studio_clay.h): the copy keeps to the others.
    const bool takes_turns = dt_s <= 0.5e-3;
    if (takes_turns && state.ticks % 2 == 0) return false;
    const double part = std::min((takes_turns ? 2.0 : 1.0) * dt_s / kCopyS, 1.0);
    copy_dents(shape, *studio, static_cast<int>(part * kDentRows) + 1);
    if (dent_row_ < kDentRows) return false;
    copy_rings(shape, studio->rings());
    shape.height_mm = studio->height_mm();
    shape.floor_mm = studio->floor_mm();
    shape.is_hollow = true;
    shape.is_dented = dented_;
    shape.tick = state.ticks;
    restart();
    return true;
}

void ShapeCopy::copy_dents(PotShape& shape, const clay::StudioClay& clay, int most) noexcept {
    for (int k = 0; k < most && dent_row_ < kDentRows; ++k, ++dent_row_) {
        float* out = shape.dents_mm_.data() + static_cast<std::size_t>(dent_row_) * kDentSectors;
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

PotShape first_shape(const HapticState& start) {
    PotShape shape;
    if (const clay::StudioClay* studio = start.studio()) {
        const auto room = static_cast<std::size_t>(studio->ring_capacity());
        for (auto* column : {&shape.outer_mm_, &shape.inner_mm_, &shape.top_mm_, &shape.film_,
                             &shape.liquidity_, &shape.load_index_})
            column->resize(room);
        shape.centre_mm_.resize(2 * room);
        shape.dents_mm_.resize(static_cast<std::size_t>(kDentRows) * kDentSectors);
    } else {
        shape.outer_mm_.resize(static_cast<std::size_t>(start.paper()->element_count()));
    }
    ShapeCopy copy;
    while (!copy.step(shape, start, 1.0)) {
    }
    return shape;
}

}  // namespace onggi::haptic

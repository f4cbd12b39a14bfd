#include "game/haptic/pot_shape.h"

#include <algorithm>

namespace onggi::haptic {
namespace {

// How long the copy of a studio pot takes: two a frame at 60 Hz.
constexpr double kCopyS = 1.0 / 120.0;

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
    copy_rings(shape, *studio, static_cast<int>(part * studio->ring_count()) + 1);
    copy_dents(shape, *studio, static_cast<int>(part * kDentRows) + 1);
    if (reached_mm_ < studio->height_mm() || dent_row_ < kDentRows) return false;
    shape.rings = copied_;
    shape.height_mm = reached_mm_;
    shape.floor_mm = studio->floor_mm();
    shape.is_hollow = true;
    shape.is_dented = dented_;
    shape.tick = state.ticks;
    restart();
    return true;
}

void ShapeCopy::copy_rings(PotShape& shape, const clay::StudioClay& clay, int most) noexcept {
    const clay::studio::Rings& rings = clay.rings();
    const int room = static_cast<int>(shape.outer_mm_.size());
    if (rings.count == 0 || copied_ == room) {  // nothing on the wheel, or nothing left to fill
        reached_mm_ = clay.height_mm();
        return;
    }
    if (reached_mm_ >= clay.height_mm()) return;
    int i = copied_ == 0 ? 0 : rings.ring_at(reached_mm_);
    // The ring whose lower face is nearest: half of one may have been copied before it moved.
    if (copied_ > 0 && reached_mm_ > rings.centre_mm(i)) ++i;
    for (int k = 0; k < most && i < rings.count && copied_ < room; ++k, ++i, ++copied_) {
        const auto to = static_cast<std::size_t>(copied_);
        const std::size_t from = clay::studio::Rings::at(i);
        reached_mm_ = rings.bottom_mm(i) + rings.height_mm[from];
        shape.outer_mm_[to] = static_cast<float>(rings.outer_mm[from]);
        shape.inner_mm_[to] = static_cast<float>(rings.inner_mm[from]);
        shape.top_mm_[to] = static_cast<float>(reached_mm_);
        shape.centre_mm_[2 * to] = rings.centre_x_mm[from];
        shape.centre_mm_[2 * to + 1] = rings.centre_z_mm[from];
        shape.film_[to] = rings.film[from];
        shape.liquidity_[to] = rings.liquidity[from];
        shape.load_index_[to] = rings.load_index[from];
    }
    if (i == rings.count) reached_mm_ = std::max(reached_mm_, clay.height_mm());
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
        // Room for the rings there may be, and for those that come while they are copied.
        const auto room = static_cast<std::size_t>(studio->ring_capacity()) + 64;
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

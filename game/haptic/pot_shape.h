// The pot as a picture needs it, and how the haptic thread copies it out without paying for all of it in one
// tick: the map of dents bit by bit, then the rings. mm.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "game/haptic/tick.h"

namespace onggi::haptic {

// Rows of the map of dents, evenly spaced in height, and directions of each.
constexpr int kDentRows = 128;
constexpr int kDentSectors = 64;

// Rings bottom first. The vectors keep their size for the whole run, `rings` says how much of them is meant;
// the spans are that part, and empty where the clay has no such thing.
struct PotShape {
    std::uint64_t tick = 0;        // when the copy was finished
    std::uint64_t run = 0;         // of the lump it is of
    std::uint64_t states_put = 0;  // on the wheel, when the copy was begun
    int rings = 0;
    double height_mm = 0.0;
    double floor_mm = 0.0;   // where the hollow begins; 0 for the paper's clay, which has none
    bool is_hollow = false;  // the clay has an inside: inner faces, tops, centres and water are meant
    bool is_dented = false;  // the map of dents is meant

    std::vector<float> outer_mm_;
    std::vector<float> inner_mm_;
    std::vector<float> top_mm_;
    std::vector<float> centre_mm_;
    std::vector<float> film_;
    std::vector<float> liquidity_;
    std::vector<float> load_index_;
    std::vector<float> dents_mm_;

    [[nodiscard]] std::span<const float> outer_mm() const { return part(outer_mm_, 1); }
    [[nodiscard]] std::span<const float> inner_mm() const { return inside(inner_mm_, 1); }
    // Upper edge of each ring; ascending.
    [[nodiscard]] std::span<const float> top_mm() const { return inside(top_mm_, 1); }
    // x and z of each ring's centre, in the clay's frame.
    [[nodiscard]] std::span<const float> centre_mm() const { return inside(centre_mm_, 2); }
    [[nodiscard]] std::span<const float> film() const { return inside(film_, 1); }
    [[nodiscard]] std::span<const float> liquidity() const { return inside(liquidity_, 1); }
    [[nodiscard]] std::span<const float> load_index() const { return inside(load_index_, 1); }
    // kDentRows times kDentSectors: row k at (k + 1/2)/kDentRows of the height, sectors counter-clockwise in
    // the clay's frame, the first from direction +X on; each adds to both faces. Empty: round everywhere.
    [[nodiscard]] std::span<const float> dents_mm() const {
        return is_dented ? std::span<const float>(dents_mm_) : std::span<const float>();
    }

  private:
    [[nodiscard]] std::span<const float> part(const std::vector<float>& column, std::size_t each) const {
        return {column.data(), static_cast<std::size_t>(rings) * each};
    }
    [[nodiscard]] std::span<const float> inside(const std::vector<float>& column, std::size_t each) const {
        return is_hollow ? part(column, each) : std::span<const float>();
    }
};

// Copies the clay into a shape at a pace of simulated time: the dents, which change slowly, a share each
// tick; the rings in the last of them, because clay that moves meanwhile would leave a step in the wall
// wherever one tick's share met the next. Haptic thread; no allocation.
class ShapeCopy {
  public:
    // One tick's share into `shape`, which must stay the same until it is finished. True when it is.
    bool step(PotShape& shape, const HapticState& state, double dt_s) noexcept;
    // Begins anew: another clay is on the wheel.
    void restart() noexcept { *this = {}; }

  private:
    void copy_dents(PotShape& shape, const clay::StudioClay& clay, int most) noexcept;

    int dent_row_ = 0;
    bool dented_ = false;
};

// A shape in its final size, whole.
[[nodiscard]] PotShape first_shape(const HapticState& start);

}  // namespace onggi::haptic

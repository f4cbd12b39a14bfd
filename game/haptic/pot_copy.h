// How the haptic thread copies the pot out for everybody else without paying for all of it in one tick: the
// map of dents bit by bit, then the rings.
#pragma once

#include <cstdint>

#include "game/haptic/tick.h"
#include "game/pot/pot.h"

namespace onggi::haptic {

constexpr int kDentRows = 128;  // of the map of dents that is copied

// When a copy was made, and of what.
struct PotStamp {
    std::uint64_t tick = 0;        // when it was finished
    std::uint64_t run = 0;         // of the lump it is of
    std::uint64_t states_put = 0;  // on the wheel, when it was begun
};

struct PotCopy {
    pot::Pot pot;
    PotStamp stamp;
};

// Copies the clay into a pot at a pace of simulated time: the dents, which change slowly, a fraction each
// tick; the rings in the last of them, because clay that moves meanwhile would leave a step in the wall
// wherever one tick's fraction met the next. Haptic thread; no allocation.
class PotCopier {
  public:
    // One tick's fraction into `pot`, which comes from pot_of() and must stay the same until it is finished.
    // True when it is.
    bool step(pot::Pot& pot, const HapticState& state, double dt_s) noexcept;
    // Begins anew: another clay is on the wheel.
    void restart() noexcept { *this = {}; }

  private:
    void copy_dents(pot::Pot& pot, const clay::StudioClay& clay, int most) noexcept;

    int dent_row_ = 0;
    bool dented_ = false;
};

// A state's pot, whole, with room for as many rings as its clay may come to have.
[[nodiscard]] pot::Pot pot_of(const HapticState& state);

}  // namespace onggi::haptic

// Copies the pot on the haptic thread for all other threads, spread over several ticks: the dent map in
// parts, then the rings.
#pragma once

#include <cstdint>

#include "game/haptic/tick.h"
#include "game/pot/pot.h"

namespace onggi::haptic {

constexpr int kDentRows = 128;  // rows of the copied dent map

// Time and source of a copy.
struct PotStamp {
    std::uint64_t tick = 0;        // when the copy was finished
    std::uint64_t run = 0;         // the lump's run
    std::uint64_t states_put = 0;  // states put on the wheel before the copy began
};

struct PotCopy {
    pot::Pot pot;
    PotStamp stamp;
};

// Copies the clay into a pot over a fixed simulated time: in each tick a part of the dents, which change
// slowly, and in the last tick all rings, because moving clay would otherwise leave a step in the wall
// between two parts. Haptic thread; no allocation.
class PotCopier {
  public:
    // Copies one tick's part into `pot`, which comes from pot_of() and must be the same until the copy is
    // finished. Returns true when it is.
    bool step(pot::Pot& pot, const HapticState& state, double dt_s) noexcept;
    // Restarts the copy: another clay is on the wheel.
    void restart() noexcept { *this = {}; }

  private:
    void copy_dents(pot::Pot& pot, const clay::StudioClay& clay, int most) noexcept;

    int dent_row_ = 0;
    bool dented_ = false;
};

// A complete copy of a state's pot, with capacity for all rings that its clay may get.
[[nodiscard]] pot::Pot pot_of(const HapticState& state);

}  // namespace onggi::haptic

#include "game/wheel/settling.h"

#include <cmath>

namespace onggi::wheel {

Settling settled(const Settling& now, double goal, double rate_per_s, double dt_s) {
    // x'' = -2 r x' - r^2 x about the goal, solved: (x0 + (v0 + r x0) t) exp(-r t).
    const double away = now.value - goal;
    const double push = now.speed + rate_per_s * away;
    const double decay = std::exp(-rate_per_s * dt_s);
    return {.value = goal + (away + push * dt_s) * decay,
            .speed = (now.speed - rate_per_s * push * dt_s) * decay};
}

}  // namespace onggi::wheel

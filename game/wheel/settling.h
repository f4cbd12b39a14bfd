// One number on its way to a goal: a spring that is damped just so that it never swings past. Any thread;
// pure.
#pragma once

namespace onggi::wheel {

struct Settling {
    double value = 0.0;
    double speed = 0.0;  // a second

    friend bool operator==(const Settling&, const Settling&) = default;
};
// After dt_s seconds; exact for any step. After 5 / rate_per_s about 96 % of the way is done.
[[nodiscard]] Settling settled(const Settling& now, double goal, double rate_per_s, double dt_s);

}  // namespace onggi::wheel

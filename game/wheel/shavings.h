// Shavings of a trimmer: curls that leave the wall, fall, slide off the turning wheel and lie in the pan.
// Only for the picture; the clay's ledger has the volume that was cut. Pure but for its own memory; any
// thread. mm, s, rad.
#pragma once

#include <random>
#include <vector>

#include "engine/math/math.h"

namespace onggi::wheel {

struct ShavingSight {
    double shaved_mm3 = 0.0;  // since the trimmer was taken up; a smaller value than before means an undo
    dvec3 from_mm{0.0};       // place of the cut
    double wheel_speed_rad_s = 0.0;
};

class Shavings {
  public:
    static constexpr std::size_t kMost = 32;   // the oldest are removed
    static constexpr double kCurlMm3 = 400.0;  // volume shown as one curl

    // Advances by dt_s (0: nothing moves, as for a still). With moves_less no curl flies.
    void follow(const ShavingSight& sight, double dt_s, bool moves_less = false);
    // Transforms of the curls' models.
    [[nodiscard]] std::vector<mat4> places() const;

  private:
    enum class Stage { kFlies, kOnHead, kInPan };
    struct Curl {
        Stage stage = Stage::kFlies;
        dvec3 at_mm{0.0};
        dvec3 velocity_mm_s{0.0};
        double yaw_rad = 0.0;
        double roll_rad = 0.0;
        double spin_rad_s = 0.0;
        double size = 1.0;
    };

    [[nodiscard]] Curl cut_off(const ShavingSight& sight);
    // A random number between those two.
    [[nodiscard]] double any(double least, double most);

    std::vector<Curl> curls_;  // oldest first
    double shown_mm3_ = 0.0;   // volume already shown as curls
    std::minstd_rand chance_{24};
};

}  // namespace onggi::wheel

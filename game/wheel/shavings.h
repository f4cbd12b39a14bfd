// What flies off the clay. Shavings of a trimmer: curls that leave the wall, fall, slide off the turning
// wheel and lie in the pan. Drops of slip from wet hands: they leave the wall and fall. Only for the picture;
// the clay's ledger has the volumes. Pure but for its own memory; any thread. mm, s, rad.
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

    std::vector<Curl> curls_;  // oldest first
    double shown_mm3_ = 0.0;   // volume already shown as curls
    std::minstd_rand chance_{24};
};

struct SplashSight {
    double film = 0.0;   // water on the hand, 0 to 1; 0 also while it does not touch
    dvec3 from_mm{0.0};  // the touch
    double wheel_speed_rad_s = 0.0;
};

class Splash {
  public:
    // Drops a second from a dripping hand at 120 rev/min; proportionally fewer from a drier one and a slower
    // wheel.
    static constexpr double kDropsPerS = 40.0;

    // As Shavings::follow().
    void follow(const SplashSight& sight, double dt_s, bool moves_less = false);
    [[nodiscard]] std::vector<mat4> places() const;

  private:
    struct Drop {
        dvec3 at_mm{0.0};
        dvec3 velocity_mm_s{0.0};
        double size = 1.0;
    };
    std::vector<Drop> drops_;
    double owed_ = 0.0;  // drops that are due, less than 1 after each call
    std::minstd_rand chance_{31};
};

}  // namespace onggi::wheel

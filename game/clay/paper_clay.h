// The paper's clay: a stack of thin cylinders that a spherical tool presses smaller while the wheel turns.
// G. Han, J. Kim, S. Choi, "Virtual Pottery Modeling with Force Feedback Using Cylindrical Element Method".
// Pure functions on plain state: any one thread at a time; the tick allocates nothing and cannot fail.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/math/math.h"

namespace onggi::clay {

constexpr int kMinElements = 100;
constexpr int kMaxElements = 200000;

// The lump before anyone has touched it.
struct PaperLump {
    int element_count = 2000;
    double height_mm = 200.0;  // H
    double radius_mm = 60.0;   // R_0
};

// Constants of the equations, with the paper's values where it gives them.
struct PaperParameters {
    double rate_hz = 1000.0;                        // f, the tick rate
    double softness_c1_per_mm = 10.0;               // c1 of Eq. (2); c1 r1 > 1 is enforced
    double viscosity_c2_n_s_per_mm = 0.002;         // c2 of Eq. (6)
    double friction_c3_n_s_per_mm = 0.0001;         // c3 of Eq. (7)
    double stiffness_turning_n_per_mm = 0.1;        // K of Eq. (4) while the wheel turns
    double stiffness_standing_n_per_mm = 0.5;       // K of Eq. (4) while it stands
    double wheel_speed_rad_s = 12.566370614359172;  // v2 of Eq. (7): 120 rev/min = 4 pi rad/s
    double minimum_radius_mm = 2.0;                 // R_min, the floor of Eq. (2)
};

// Everything of the clay that a tick reads and writes.
class PaperClay {
  public:
    explicit PaperClay(const PaperLump& lump = {});

    [[nodiscard]] int element_count() const { return element_count_; }
    [[nodiscard]] double height_mm() const { return height_mm_; }
    [[nodiscard]] double element_height_mm() const { return height_mm_ / element_count_; }
    // R_i, bottom first, element_count() of them.
    [[nodiscard]] std::span<const float> radii_mm() const;
    // For a recorded start state and for tests: sets all radii. Precondition: as many as elements, all
    // finite.
    void set_radii_mm(std::span<const float> radii_mm);

    // sum of pi R_i^2 H/N, mm^3, in double.
    [[nodiscard]] double volume_mm3() const;
    // Of all that a later tick depends on, for replay checks. No allocation.
    [[nodiscard]] std::uint64_t state_hash() const;
};

}  // namespace onggi::clay

// The paper's equations once more, written down as they are printed: every element is an object with its
// centre, radius, height and normal, all in double, and every one of them is visited every tick. It shares no
// code with game/clay beyond the types of its input and output. Tests compare the clay with it, and
// benchmarks use it as the baseline. Any one thread at a time. Units: mm, N, s, rad.
#pragma once

#include <span>
#include <vector>

#include "engine/math/math.h"
#include "game/clay/paper_clay.h"

namespace onggi::clay {

// The parameters by which section IV of the paper represents a cylindrical element.
struct PaperElement {
    dvec3 centre_mm;
    double radius_mm;
    double height_mm;
    dvec3 top_normal;
};

class PaperReference {
  public:
    explicit PaperReference(const PaperLump& lump = {});

    ContactForces tick(const ToolInput& tool, const PaperParameters& parameters);

    [[nodiscard]] std::span<const PaperElement> elements() const { return elements_; }
    void set_radius_mm(int first, int count, double radius_mm);

  private:
    std::vector<PaperElement> elements_;
    dvec3 previous_position_mm_{0.0};
    bool first_tick_ = true;
    dvec3 radial_unit_{1.0, 0.0, 0.0};
    // std::pow is called only when one of these changes, to keep the baseline fast.
    double fraction_c1_ = 0.0;
    double fraction_r1_ = 0.0;
    double fraction_rate_hz_ = 0.0;
    double fraction_ = 0.0;
};

}  // namespace onggi::clay

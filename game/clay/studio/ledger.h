// Where every cubic millimetre of the lump is. Plain state; fit for the tick. Units: mm^3, all on the grid.
#pragma once

namespace onggi::clay::studio {

struct Ledger {
    double lump_mm3 = 0.0;       // what was put on the wheel
    double trimmings_mm3 = 0.0;  // cut off by the trimming tool, the wire, or torn off
    double slip_mm3 = 0.0;       // carried away wet by the sponge

    // What has to be there still, while the error is 0.
    [[nodiscard]] double on_wheel_mm3() const { return lump_mm3 - (trimmings_mm3 + slip_mm3); }
    // What is not accounted for: 0 exactly, or there is a bug.
    [[nodiscard]] double error_mm3(double on_wheel_mm3) const {
        return lump_mm3 - (on_wheel_mm3 + trimmings_mm3 + slip_mm3);
    }
};

}  // namespace onggi::clay::studio

// Pots of the studio's clay for the golden pictures, computed by formula, so that changes of the clay model
// do not change the pictures. Any thread; mm.
#pragma once

#include <functional>

#include "game/pot/pot.h"

namespace onggi::golden {

// The shape of a pot by height, mm.
struct StudioShape {
    double height_mm = 150.0;
    double floor_mm = 9.0;
    std::function<double(double)> outer_mm;
    std::function<double(double)> wall_mm;  // null: solid
    double rings_mm = 0.3;                  // how deep fingers left their rings
    double liquidity = 0.6;
    double film = 0.6;
};
[[nodiscard]] pot::Pot studio_pot(const StudioShape& shape);

// Bell-shaped about a centre.
[[nodiscard]] double bump(double y, double centre, double width);

[[nodiscard]] StudioShape jar();
[[nodiscard]] StudioShape bottle();  // with a neck of 15 mm radius
[[nodiscard]] StudioShape bowl();
[[nodiscard]] StudioShape plate();  // 270 mm across
[[nodiscard]] StudioShape cylinder();
[[nodiscard]] StudioShape lump();          // solid
[[nodiscard]] StudioShape cone();          // a lump raised between the hands
[[nodiscard]] StudioShape opened();        // thick walls and the first hollow
[[nodiscard]] StudioShape widened();       // the same, its floor wide
[[nodiscard]] StudioShape bellied();       // a cylinder with a belly
[[nodiscard]] StudioShape collared();      // a jar, its neck drawn in
[[nodiscard]] StudioShape thick_rimmed();  // pressed from above
[[nodiscard]] StudioShape trimmed();       // leather-hard, a foot cut under a bowl
[[nodiscard]] StudioShape rough();         // 150 grooves of one pixel in a picture of 720

// A thumb's mark at a height and a direction, counter-clockwise from the clay's +X.
void press_dent(pot::Pot& pot, double y_mm, double direction_rad, double depth_mm, double width_mm);
// The pot leans: its top stands off the axis.
void lean(pot::Pot& pot, double x_mm, double z_mm);
// A collapsed pot: a belly that sank and bulged to one side, and the load that caused it.
void slump(pot::Pot& pot);

}  // namespace onggi::golden

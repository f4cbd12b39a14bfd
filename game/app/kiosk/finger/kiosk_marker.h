// The marker of keys and a single switch: on the clay's silhouette, or over its middle while the clay can be
// opened. Each key moves the marker or requests a touch there. Pure state. Main thread. mm.
#pragma once

#include <optional>

#include "game/app/kiosk/finger/kiosk_touch.h"

namespace onggi::app {

enum class FingerKey { kUp, kDown, kLeft, kRight };

class KioskMarker {
  public:
    // An arrow key. Up and down move the marker along the wall. At the rim of an opened pot and over its
    // middle, up pulls; at the rim of solid clay, up moves the marker over the middle, where down opens and
    // left and right return to the rim. Left and right move the wall to that side of the picture. The first
    // key shows the marker low on `side` (+1 right).
    [[nodiscard]] std::optional<TouchPath> key(FingerKey key, const pot::Pot& shape, double side);
    // A button on the screen, for visitors who cannot move a marker: up raises, down opens solid clay or
    // lowers a pot; left and right are as above.
    [[nodiscard]] TouchPath button(FingerKey key, const pot::Pot& shape, double side);

    [[nodiscard]] std::optional<dvec2> place_mm(const pot::Pot& shape) const;
    void hide() { is_shown_ = false; }

  private:
    void come(double side);
    void walk(double way_mm, const pot::Pot& shape);
    [[nodiscard]] TouchPath move_wall(double direction, const pot::Pot& shape) const;
    [[nodiscard]] bool is_at_rim() const { return fraction_ >= 1.0; }

    bool is_shown_ = false;
    bool is_over_ = false;  // over the middle of the clay
    double side_ = 1.0;
    double fraction_ = 0.0;  // of the clay's height, so that it rises with a growing pot; 1: at the rim
};

}  // namespace onggi::app

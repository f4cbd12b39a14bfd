// Where keys and a single switch work: a marker on the clay's silhouette, or over its middle while there is
// something to open. Each key moves it or asks for a touch there. Pure state. Main thread. mm.
#pragma once

#include <optional>

#include "game/app/kiosk/hand/kiosk_touch.h"

namespace onggi::app {

enum class HandKey { kUp, kDown, kLeft, kRight };

class KioskMarker {
  public:
    // An arrow key: up and down move the marker along the wall; at the rim of an opened pot up pulls, at that
    // of solid clay it goes over the middle, where down opens and the others lead back to the rim. Left and
    // right move the wall to that side, as seen. The first brings the marker: low on that side, +1 right.
    [[nodiscard]] std::optional<TouchPath> key(HandKey key, const pot::Pot& shape, double side);
    // A button on the screen, for who cannot walk a marker: up is higher, down opens solid clay and lowers a
    // pot; left and right are as above.
    [[nodiscard]] TouchPath button(HandKey key, const pot::Pot& shape, double side);

    [[nodiscard]] std::optional<dvec2> place_mm(const pot::Pot& shape) const;
    void hide() { is_shown_ = false; }

  private:
    void come(double side);
    void walk(double way_mm, const pot::Pot& shape);
    [[nodiscard]] TouchPath move_wall(double direction, const pot::Pot& shape) const;
    [[nodiscard]] bool is_at_rim() const { return fraction_ >= 1.0; }

    bool is_shown_ = false;
    bool is_over_ = false;  // the middle of the clay
    double side_ = 1.0;
    double fraction_ = 0.0;  // of the clay's height, so that it goes up with a pot that grows; 1: at the rim
};

}  // namespace onggi::app

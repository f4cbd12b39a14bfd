// Where the kiosk's camera looks from and how much of the picture it leaves to the ledge and the words: by
// the design's boxes, and so that pot and hands are inside them. Main thread. px and mm, as named.
#pragma once

#include <functional>
#include <optional>

#include "game/kiosk/config.h"
#include "game/kiosk/state.h"
#include "game/wheel/workshop_files.h"

namespace onggi::app {

// What the camera is asked for.
struct CameraRequest {
    wheel::View view = wheel::View::kThrowing;
    wheel::Framing framing{};
    bool sways = false;
    double evening = 0.0;

    friend bool operator==(const CameraRequest&, const CameraRequest&) = default;
};

// The picture, and where a view framed so shows a place in it; as LiveView::project_framed.
struct BackgroundSight {
    int width_px = 0;
    int height_px = 0;
    std::function<std::optional<dvec2>(wheel::View, const wheel::Framing&, const dvec3&)> project{};
};

class KioskCamera {
  public:
    // pot_mm: the pot's height now. shows_room: nothing but the scene is on the screen.
    [[nodiscard]] CameraRequest request(const kiosk::State& state, bool shows_room, double pot_mm,
                                        const BackgroundSight& sight);

  private:
    double fitted_mm_ = 0.0;  // the height that the framing has room for
};

// 0 by day; over the last hour before closing time it grows, in steps that nobody sees happen, to the 1 that
// it stays until the museum opens. Always open is always day.
[[nodiscard]] double evening_at(const kiosk::Config& config, int minute_of_day);

// Where the photographed room ends in a picture framed so, px: beyond it there is nothing to see.
struct SceneEdges {
    double left = 0.0;
    double top = 0.0;
    double right = 0.0;
};
[[nodiscard]] SceneEdges scene_edges(const wheel::Framing& framing, int width_px, int height_px);

}  // namespace onggi::app

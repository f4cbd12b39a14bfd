// The kiosk camera's view and framing: pot and hands fit into the design's boxes beside the ledge and the
// words. Main thread. px and mm, as named.
#pragma once

#include <functional>
#include <optional>

#include "game/kiosk/config.h"
#include "game/kiosk/state.h"
#include "game/wheel/workshop_files.h"

namespace onggi::app {

struct CameraRequest {
    wheel::View view = wheel::View::kThrowing;
    wheel::Framing framing{};
    bool sways = false;
    double evening = 0.0;

    friend bool operator==(const CameraRequest&, const CameraRequest&) = default;
};

// The picture, and the projection of a place with a view and framing; as LiveView::project_framed.
struct BackgroundSight {
    int width_px = 0;
    int height_px = 0;
    std::function<std::optional<dvec2>(wheel::View, const wheel::Framing&, const dvec3&)> project{};
};

class KioskCamera {
  public:
    // pot_mm: the pot's current height. shows_room: no exhibit, wall of the day or panel is over it.
    [[nodiscard]] CameraRequest request(const kiosk::State& state, bool shows_room, double pot_mm,
                                        const BackgroundSight& sight);

  private:
    double fitted_mm_ = 0.0;  // the pot's height that the framing leaves room for
};

// 0 by day; grows in invisible steps over the last hour before closing time to 1, and stays 1 until the
// museum opens. Always 0 without opening hours.
[[nodiscard]] double evening_at(const kiosk::Config& config, int minute_of_day);

// The edges of the photographed room in a picture with that framing, px.
struct SceneEdges {
    double left = 0.0;
    double top = 0.0;
    double right = 0.0;
};
[[nodiscard]] SceneEdges scene_edges(const wheel::Framing& framing, int width_px, int height_px);

}  // namespace onggi::app

// What a visitor's mouse and keys mean: where the tool is wanted, and what is asked for besides. Pure state,
// no window and no clock, so that tests play the visitor. Main thread. mm, pixels.
#pragma once

#include <functional>
#include <optional>

#include "engine/haptics/tool_state.h"
#include "engine/window/events.h"

namespace onggi::app {

// What is to be done once, now.
enum class KioskAction {
    kNone,
    kQuit,
    kFreshLump,
    kSaveModel,
    kSavePicture,
    kToggleFullScreen,
};

class KioskInput {
  public:
    // From a pixel to a place on the upright plane through the wheel's axis; nothing where there is none.
    using PlaceOf = std::function<std::optional<dvec3>(double x_px, double y_px)>;

    // Takes one event; gives what it asks for.
    KioskAction handle(const window::Event& event, const PlaceOf& place_of);

    // Where the tool is wanted now, within the limits of tool_state.h and not below the wheel head.
    [[nodiscard]] const haptics::ToolState& target() const { return target_; }

  private:
    KioskAction handle_key(const window::KeyEvent& event);
    void change_radius(double steps);

    haptics::ToolState target_{.position_mm = {120.0, 150.0, 0.0}};
    bool button_held_ = false;
    bool space_held_ = false;
};

}  // namespace onggi::app

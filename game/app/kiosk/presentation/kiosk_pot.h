// What the screens need to know of the clay: how far the lesson has come, what it warns of, and the finished
// pot in a visitor's numbers. Any one thread at a time. mm.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/ui/painting.h"
#include "game/clay/studio/studio_clay.h"
#include "game/haptic/messages.h"
#include "game/heritage/target.h"
#include "game/kiosk/state.h"
#include "game/screens/page/view.h"

namespace onggi::app {

// Follows one lump from fresh to pot and says which of the three moves the clay itself shows, whatever made
// them: pressed, opened, raised.
class Lesson {
  public:
    void begin() { *this = {}; }
    // 0 to kiosk::kTeachingSteps; never less than before.
    int steps_done(const pot::Pot& shape);

  private:
    bool has_start_ = false;
    double start_height_mm_ = 0.0;
    double start_foot_mm_ = 0.0;
    double opened_height_mm_ = 0.0;  // when it was opened; 0: it is not
    double size_ = 1.0;              // of the lump, beside one of a kilogram
    int done_ = 0;
};

// What to warn of; it comes at 0.85 of what the clay bears and goes at 0.7.
[[nodiscard]] kiosk::Warning warning_of(const haptic::LoadReport& load, kiosk::Warning before);

// Which warning names that cause, in clay of that strength.
[[nodiscard]] kiosk::Warning warning_for(clay::studio::Cause cause, double strength_kpa);

// Thickness of the thinnest wall above the floor; 0 where nothing is hollow.
[[nodiscard]] double thinnest_wall_mm(const pot::Pot& shape);

// The pot as it comes out of the kiln, and beside it the one of `targets` that it was thrown after, `chosen`,
// or else resembles most, as relatives_of() shows them; no relative where those are not theirs.
[[nodiscard]] screens::FiredPot fired_pot(
    const clay::StudioClay& clay, const std::vector<heritage::Target>& targets,
    const std::shared_ptr<const std::vector<screens::Exhibit>>& relatives,
    std::optional<std::size_t> chosen = std::nullopt);
// A portrait on the evening museum's wall, square.
[[nodiscard]] ui::Painting portrait(const pot::Section& shape, int glaze, int side_px);

}  // namespace onggi::app

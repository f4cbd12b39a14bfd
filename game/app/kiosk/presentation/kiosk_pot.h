// Facts about the clay for the screens: the lesson's progress, warnings, and the finished pot with its
// measures. Any one thread at a time. mm.
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

// Follows one lump from fresh to pot and detects the three moves of the lesson by the clay's shape,
// independent of the tool: pressed, opened, raised.
class Lesson {
  public:
    void begin() { *this = {}; }
    // 0 to kiosk::kTeachingSteps; never less than before.
    int steps_done(const pot::Pot& shape);

  private:
    bool has_start_ = false;
    double start_height_mm_ = 0.0;
    double start_foot_mm_ = 0.0;
    double opened_height_mm_ = 0.0;  // height when it was opened; 0: not opened
    double size_ = 1.0;              // relative to a lump of a kilogram
    int done_ = 0;
};

// The warning, which starts at 0.85 of the clay's strength and ends at 0.7.
[[nodiscard]] kiosk::Warning warning_of(const haptic::LoadReport& load, kiosk::Warning before);

// The warning for that cause, in clay of that strength.
[[nodiscard]] kiosk::Warning warning_for(clay::studio::Cause cause, double strength_kpa);

// Thickness of the thinnest wall above the floor; 0 for solid clay.
[[nodiscard]] double thinnest_wall_mm(const pot::Pot& shape);

// The wall from a little above the floor to the rim, across its lean; zeros for solid clay.
struct AcrossWall {
    double thickest_mm = 0.0;
    double mean_mm = 0.0;
};
[[nodiscard]] AcrossWall across_wall(const pot::Pot& shape);

// The thickest wall in whole mm, if it or the mean is too thick for a pot of that much clay; 0 if not, or for
// solid clay.
[[nodiscard]] int thick_wall_mm(const pot::Pot& shape);

// Returns the pot as it comes out of the kiln and, as its relative, the museum's pot that it was thrown after
// (`chosen`) or else the most similar of `targets`. `relatives` is relatives_of(targets); if their sizes
// differ, there is no relative.
[[nodiscard]] screens::FiredPot fired_pot(
    const clay::StudioClay& clay, const std::vector<heritage::Target>& targets,
    const std::shared_ptr<const std::vector<screens::Exhibit>>& relatives,
    std::optional<std::size_t> chosen = std::nullopt);
// A square portrait on the evening museum's wall.
[[nodiscard]] ui::Painting portrait(const pot::Section& shape, int glaze, int side_px);

}  // namespace onggi::app

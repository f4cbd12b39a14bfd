// The pots of the golden pictures: each shows a feature that another could hide. Any thread; mm.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "game/look/lathe_marks.h"
#include "game/wheel/still.h"
#include "tests/golden/golden_pots.h"

namespace onggi::golden {

// The decoration on a pot, and the glaze over it.
struct DrawnPot {
    std::optional<render::LatheMaterial> material;  // empty: its clay's own
    look::DressedMarks marks;
};

struct GoldenScene {
    std::string name;
    int width = 640;
    int height = 480;
    pot::Pot pot{};
    dvec3 tool_position_mm{110.0, 150.0, 0.0};
    double tool_radius_mm = 10.0;
    bool tool_shown = true;
    std::optional<dvec3> second_hand_mm = std::nullopt;
    tool::Tool tool = tool::Tool::kHand;
    std::optional<tool::Side> side = std::nullopt;        // side of the hand; default: outside
    std::optional<double> wire_height_mm = std::nullopt;  // drawn through the clay there
    dvec2 wheel_direction{1.0, 0.0};
    int contacts = 0;
    wheel::StillView view = wheel::StillView::kThrowing;
    std::shared_ptr<const DrawnPot> drawn = nullptr;

    // Brings hands and pot into the scene of a picture, and returns the snapshot that goes with them. Both
    // refer to this one.
    [[nodiscard]] haptic::Snapshot shown(wheel::WheelScene& scene) const;
    // A picture of the pot by a camera of its own.
    [[nodiscard]] Result<asset::Image> drawn_alone(int width_px, int height_px,
                                                   const wheel::StillOptions& options) const;
    // A hash of everything that the picture shows.
    [[nodiscard]] std::uint64_t hash() const;

    // Printed by GoogleTest.
    friend std::ostream& operator<<(std::ostream& out, const GoldenScene& scene) { return out << scene.name; }
};

// Made once: drawing on them takes its time.
[[nodiscard]] const std::vector<GoldenScene>& golden_scenes();
// The scene of that name; its name is empty if there is none.
[[nodiscard]] GoldenScene scene_named(std::string_view name);
// As GoogleTest wants it: letters, digits and underscores.
[[nodiscard]] std::string test_name(const GoldenScene& scene);

}  // namespace onggi::golden

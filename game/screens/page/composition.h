// A composed screen: its pictures, targets and texts with their places. Composed on a background thread,
// drawn and queried by the frame. Immutable; any thread. Lengths are u.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "engine/ui/colour.h"
#include "engine/ui/geometry.h"
#include "engine/ui/painting.h"
#include "game/kiosk/screen.h"
#include "game/screens/page/cue.h"
#include "game/screens/pots/turning_pot.h"

namespace onggi::screens {

// How an item appears after its screen has come, and flickers. Still screens and pictures show its end.
struct Motion {
    float begins_s = 0.0F;  // since the screen came
    float lasts_s = 0.0F;
    float from_alpha = 1.0F;
    float to_alpha = 1.0F;
    float from_y_u = 0.0F;  // from above (negative) or below to its place
    float flicker = 0.0F;   // fraction by which it dims and brightens
    float phase_rad = 0.0F;

    friend bool operator==(const Motion&, const Motion&) = default;
};
// How an item stands some seconds after its screen has come, and at the end.
struct Moved {
    float alpha = 1.0F;
    float down_u = 0.0F;
};
[[nodiscard]] Moved moved(const Motion& motion, double since_s);
[[nodiscard]] Moved moved_to_the_end(const Motion& motion);

struct Item {
    ui::Rect rect;
    std::uint64_t key = 0;                         // key of its painting in the atlas; 0: a shaded box
    std::shared_ptr<const ui::Painting> painting;  // null: a shaded box
    std::array<ui::Colour, 4> corners{};           // of a box: top left, top right, bottom right, bottom left
    int target = -1;                               // sinks while this target is pressed
    std::uint64_t pressed_key = 0;
    std::shared_ptr<const ui::Painting> pressed_painting;
    float alpha = 1.0F;  // less than 1: disabled
    bool is_words = false;
    std::shared_ptr<const TurningPot> turning;  // `painting` is its first picture
    Motion motion{};
};

struct Target {
    kiosk::Button button = kiosk::Button::kNone;
    int value = 0;
    ui::Rect rect{};
    std::string name{};    // shown next to the scanning ring
    std::string key{};     // of the name in the tables; may be empty
    std::string spoken{};  // with the target's present setting
    bool repeats = false;  // repeats while held
    ui::Rect also{};       // the object in the picture that the target stands for, which can be pressed too

    [[nodiscard]] bool lies_under(vec2 at) const { return rect.contains(at) || also.contains(at); }
};

// A text and its place, for the audit.
struct Writing {
    std::string words;
    ui::Rect rect;  // of its lines, without the line spacing
    float size = 0.0F;
    ui::Colour colour;
    ui::Rect within;  // the box that it must fit into
    int unknown_glyphs = 0;
    bool too_wide = false;
    bool over = false;    // covers other words
    bool on_pot = false;  // may overlap a pot's box, as cards do
};

// The three forces of a touch, as in Fig. 6 of the paper, and their sum, Eq. (3).
enum class Force { kStiffness, kViscosity, kFriction, kTotal };
constexpr std::size_t kForceCount = 4;

// The parts that the stage needs to show forces, apart from its arrows: a name for each arrow, digits for the
// changing numbers, and the places in the panel.
struct ForceParts {
    std::array<Item, kForceCount> names;  // only size and painting are used
    std::array<Item, 10> digits;
    Item point;
    bool has_panel = false;
    // The right end and vertical middle of each number.
    std::array<vec2, kForceCount> value_at{};
    vec2 full_at{0.0F};  // the label of the force plot's full height
    vec2 rate_at{0.0F};
    ui::Rect force_plot;
    ui::Rect rate_plot;
};

struct Composition {
    ui::Rect bounds;  // 0, 0, width, height
    float px_per_u = 1.0F;
    float mm_per_u = 0.4151F;
    bool covers = false;           // hides the scene completely
    bool plays_by_itself = false;  // without an audience
    std::vector<Item> items;
    std::vector<Target> targets;
    std::vector<Writing> writings;
    std::vector<std::string> told;             // to visitors by ear, of a staff's panel, in English
    std::vector<ui::Rect> pots;                // must stay free of words
    std::shared_ptr<const ForceParts> forces;  // set if forces may be shown
    bool has_cue = false;                      // the clay can be touched, so cues are shown
    // Labels of the reasons why the clay follows the finger only in part; only size and painting are used.
    std::array<Item, kCueGuardCount> guard_words;
};

}  // namespace onggi::screens

// A composed screen: where every picture lies, what can be pressed, and what stands in words where. Made
// beside the frame, drawn and asked by the frame. Any thread; not changed once made. Lengths are u.
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

struct Item {
    ui::Rect rect;
    std::uint64_t key = 0;                         // of its painting in the atlas; 0: a shaded box
    std::shared_ptr<const ui::Painting> painting;  // null: a shaded box
    std::array<ui::Colour, 4> corners{};           // of a box: top left, top right, bottom right, bottom left
    int target = -1;                               // it sinks with this target when that is pressed
    std::uint64_t pressed_key = 0;
    std::shared_ptr<const ui::Painting> pressed_painting;
    float alpha = 1.0F;  // less: it cannot be used now
    bool is_words = false;
    std::shared_ptr<const TurningPot> turning;  // its painting is how it begins
};

struct Target {
    kiosk::Button button = kiosk::Button::kNone;
    int value = 0;
    ui::Rect rect;
    std::string name;      // spoken, and shown beside the scanning ring
    bool repeats = false;  // while held
    ui::Rect also{};       // what it stands for, in the picture: touching that presses it too

    [[nodiscard]] bool lies_under(vec2 at) const { return rect.contains(at) || also.contains(at); }
};

// For the audit: a text as it stands.
struct Writing {
    std::string words;
    ui::Rect rect;  // of its lines, without the air between them
    float size = 0.0F;
    ui::Colour colour;
    ui::Rect within;  // the box it must not leave
    int unknown_glyphs = 0;
    bool too_wide = false;
    bool over = false;    // laid over other words, which it hides
    bool on_pot = false;  // allowed to stand over a pot's box: cards do
};

// The three forces of a touch, as in Fig. 6 of the paper, and their sum, Eq. (3).
enum class Force { kStiffness, kViscosity, kFriction, kTotal };
constexpr std::size_t kForceCount = 4;

// What the stage shows forces with, besides its arrows: a name for the head of each, digits for the numbers
// that change from frame to frame, and where in the panel they go.
struct ForceParts {
    std::array<Item, kForceCount> names;  // only their size and painting count
    std::array<Item, 10> digits;
    Item point;
    bool has_panel = false;
    // Of each number, its right end and the middle of its height.
    std::array<vec2, kForceCount> value_at{};
    vec2 full_at{0.0F};  // what the height of the force's plot stands for
    vec2 rate_at{0.0F};
    ui::Rect force_plot;
    ui::Rect rate_plot;
};

struct Composition {
    ui::Rect bounds;  // 0, 0, width, height
    float px_per_u = 1.0F;
    float mm_per_u = 0.4151F;
    bool covers = false;           // nothing of the scene is seen
    bool plays_by_itself = false;  // for nobody in particular
    std::vector<Item> items;
    std::vector<Target> targets;
    std::vector<Writing> writings;
    std::vector<ui::Rect> pots;                // no words in these
    std::shared_ptr<const ForceParts> forces;  // where forces may be shown
    bool has_cue = false;                      // where the clay may be touched
    // Why it does less than the finger asks, as pictures; only their size and painting count.
    std::array<Item, kCueGuardCount> guard_words;
};

}  // namespace onggi::screens

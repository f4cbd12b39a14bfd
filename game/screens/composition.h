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
#include "game/kiosk/step.h"

namespace onggi::screens {

// How an item behaves between two compositions.
enum class Role {
    kStill,
    kHint,  // ghost hands and paths: fade with the hint, and move along its way
};

struct Item {
    ui::Rect rect;
    std::uint64_t key = 0;                         // of its painting in the atlas; 0: a shaded box
    std::shared_ptr<const ui::Painting> painting;  // null: a shaded box
    std::array<ui::Colour, 4> corners{};           // of a box: top left, top right, bottom right, bottom left
    int target = -1;                               // it sinks with this target when that is pressed
    std::uint64_t pressed_key = 0;
    std::shared_ptr<const ui::Painting> pressed_painting;
    Role role = Role::kStill;
    vec2 way{0.0F};  // of a hint: how far it goes in a loop
    bool is_words = false;
};

struct Target {
    kiosk::Button button = kiosk::Button::kNone;
    int value = 0;
    ui::Rect rect;
    std::string name;      // spoken, and shown beside the scanning ring
    bool repeats = false;  // while held
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
    bool on_pot = false;  // allowed to stand over a pot's box: cards do
};

struct Composition {
    ui::Rect bounds;  // 0, 0, width, height
    float px_per_u = 1.0F;
    float mm_per_u = 0.4151F;
    bool covers = false;  // nothing of the scene is seen
    std::vector<Item> items;
    std::vector<Target> targets;
    std::vector<Writing> writings;
    std::vector<ui::Rect> pots;  // no words in these
};

}  // namespace onggi::screens

// The parts of all ledges under the clay: rows, steppers, and tokens with a name below. The composer's
// thread.
#pragma once

#include <vector>

#include "game/screens/page/page.h"

namespace onggi::screens {

// The ledge's extra height with larger text, for the caption's row and the labels below the tokens.
struct LedgeGrowth {
    float caption = 0.0F;
    float labels = 0.0F;
};
[[nodiscard]] LedgeGrowth growth(const Page& page);

[[nodiscard]] float ledge_top(const Page& page);
// The height of the names below one row.
[[nodiscard]] float label_height(const Page& page);
// The top of the tokens' row; a tall picture has a second row below it.
[[nodiscard]] float row_y(const Page& page);
[[nodiscard]] float second_row_y(const Page& page);
// Words are aligned to the hand's side.
[[nodiscard]] ui::Align along_ledge(const Page& page);

// The setting that a stepper changes.
struct Setting {
    Icon icon;
    const char* key;
    int most;
    int now;
    kiosk::Button less;
    kiosk::Button more;
};
[[nodiscard]] Setting size_setting(const kiosk::Throwing& throwing);
[[nodiscard]] Setting water_setting(const kiosk::Throwing& throwing);
[[nodiscard]] Setting speed_setting(const kiosk::Throwing& throwing);

// `place` is for a right-handed, left-to-right ledge. `rests`: visible but disabled.
void add_stepper(Page& page, const ui::Rect& place, const Setting& setting, bool rests);
// Adds a token with its name below, at most `label_width` wide; returns its target.
int add_round(Page& page, const ui::Rect& place, Icon icon, kiosk::Button button, const char* key,
              float label_width, int value = 0);

// One of several choices, or a switch.
struct LedgeChoice {
    Icon icon;
    const char* key;
    kiosk::Button button;
    int value = 0;
    bool chosen = false;
};
// Adds a token with its name below, `name_height` high and `spread` wider than the token on each side; the
// chosen one is ticked and underlined.
void add_choice(Page& page, const ui::Rect& place, const LedgeChoice& choice, float name_height,
                float spread);

// The token of the tool in the hand, with a sign for more: opens the tray.
void add_held_token(Page& page, const ui::Rect& place, float label_width);
// The tool tray on the ledge: the tools, their size, and back.
void add_tool_tray(Page& page);
// The name of the current step: below the steps and `wide` u wide, or to their right from `beside`.
void add_step_caption(Page& page, const std::string& text, float wide, float beside);
// The place of the languages' token above the ledge with low controls; `tall_x` is its left edge on a tall
// picture.
[[nodiscard]] ui::Rect low_languages(const Page& page, float tall_x = design::kMargin);
// The four keys that move the hand.
void add_hand_pad(Page& page);
// Adds a card as high as its words; if that exceeds `most`, shrinks the words. Returns its place.
ui::Rect add_paper(Page& page, const ui::Rect& most, const std::vector<Words>& lines);
// The five steps of a jar of two bowls side by side, `pitch` apart; `current` is the present step, -1 before
// the first.
void add_jar_pictograms(Page& page, vec2 at, float pitch, int current);
// The same in place of the lesson's steps, with the current step's name.
void add_jar_steps(Page& page);
// The ledges while the first bowl is set aside, and while it stands on the second.
void add_aside_ledge(Page& page);
void add_join_ledge(Page& page);
// The card that explains the step, until the clay is touched.
void add_jar_card(Page& page);
// The ledge while the wire is held: its height, and the cut.
void add_wire_ledge(Page& page);

}  // namespace onggi::screens

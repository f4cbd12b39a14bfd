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

// The name of the current step: below the steps and `wide` u wide, or to their right from `beside`.
void add_step_caption(Page& page, const std::string& text, float wide, float beside);
// The place of the languages' token above the ledge with low controls; `tall_x` is its left edge on a tall
// picture.
[[nodiscard]] ui::Rect low_languages(const Page& page, float tall_x = design::kMargin);
// The four keys that move the hand.
void add_hand_pad(Page& page);
// Adds a card as high as its words; if that exceeds `most`, shrinks the words. Returns its place.
ui::Rect add_paper(Page& page, const ui::Rect& most, const std::vector<Words>& lines);

}  // namespace onggi::screens

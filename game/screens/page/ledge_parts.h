// What all ledges under the clay are made of: where their rows lie, steppers and tokens with a name below.
// The composer's thread.
#pragma once

#include <vector>

#include "game/screens/page/page.h"

namespace onggi::screens {

// What larger text has made the ledge higher by, for the caption's row and for the labels below the tokens.
struct LedgeGrowth {
    float caption = 0.0F;
    float labels = 0.0F;
};
[[nodiscard]] LedgeGrowth growth(const Page& page);

[[nodiscard]] float ledge_top(const Page& page);
// Of the names below one row.
[[nodiscard]] float label_height(const Page& page);
// Where the tokens' row begins; on a tall picture there is another below it.
[[nodiscard]] float row_y(const Page& page);
[[nodiscard]] float second_row_y(const Page& page);
// Words begin where the hand does.
[[nodiscard]] ui::Align along_ledge(const Page& page);

// What a stepper changes.
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

// `place` is of a ledge for the right hand, read from the left. `rests`: to be seen and not to be pressed.
void add_stepper(Page& page, const ui::Rect& place, const Setting& setting, bool rests);
// A token with its name below, that wide at most; gives its target.
int add_round(Page& page, const ui::Rect& place, Icon icon, kiosk::Button button, const char* key,
              float label_width, int value = 0);

// One of several to choose from, or what is on or off.
struct LedgeChoice {
    Icon icon;
    const char* key;
    kiosk::Button button;
    int value = 0;
    bool chosen = false;
};
// A token with its name below, that high and wider than it by `spread` to either side; what is chosen is
// ticked and underlined.
void add_choice(Page& page, const ui::Rect& place, const LedgeChoice& choice, float name_height,
                float spread);

// What the step that is being done is called: below the steps and that wide, or from `beside` on to their
// right.
void add_step_caption(Page& page, const std::string& text, float wide, float beside);
// Above the ledge, where the token of languages is brought low; `tall_x`: its left edge on a tall picture.
[[nodiscard]] ui::Rect low_languages(const Page& page, float tall_x = design::kMargin);
// The four keys that move the hand.
void add_hand_pad(Page& page);
// A card as high as its words, or where that is too high, words as small as it takes; gives where it is.
ui::Rect add_paper(Page& page, const ui::Rect& most, const std::vector<Words>& lines);

}  // namespace onggi::screens

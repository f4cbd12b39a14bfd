#include "game/screens/page/ledge_parts.h"

#include <algorithm>
#include <utility>

namespace onggi::screens {

using kiosk::Button;
using ui::Rect;

namespace {

constexpr float kBelow = 8.0F;  // room for the focus ring between a control and its label

}  // namespace

LedgeGrowth growth(const Page& page) {
    const float all = ledge_growth(page.view().state.comfort);
    if (page.shape() == Shape::kWide) return {all, all};
    return {0.45F * all, 0.55F * all};
}

float label_height(const Page& page) {
    return 36.0F + growth(page).labels * (page.is_tall() ? 0.5F : 1.0F);
}

ui::Rect low_languages(const Page& page, float tall_x) {
    const bool tall = page.is_tall();
    return {tall ? tall_x : design::kMargin, page.lower_by() + (tall ? 648.0F : 478.0F), 150.0F, 60.0F};
}

float ledge_top(const Page& page) {
    return ledge_y(page.shape(), page.height(), page.view().state.comfort);
}

float row_y(const Page& page) {
    const float above = page.by_shape(22.0F, 92.0F + growth(page).caption, 116.0F + growth(page).caption);
    return ledge_top(page) + above;
}
float second_row_y(const Page& page) {
    return row_y(page) + 132.0F + 0.5F * growth(page).labels;
}

ui::Align along_ledge(const Page& page) {
    return page.view().state.comfort.left_hand ? ui::Align::kEnd : ui::Align::kStart;
}

Setting size_setting(const kiosk::Throwing& throwing) {
    return {Icon::kTool, "tool.size", kiosk::kMostTool, throwing.tool, Button::kToolLess, Button::kToolMore};
}
Setting water_setting(const kiosk::Throwing& throwing) {
    return {Icon::kWater,   "ctl.water",        kiosk::kMostWater,
            throwing.water, Button::kWaterLess, Button::kWaterMore};
}
Setting speed_setting(const kiosk::Throwing& throwing) {
    return {Icon::kSpeed,   "ctl.speed",        kiosk::kMostSpeed,
            throwing.speed, Button::kSpeedLess, Button::kSpeedMore};
}

void add_stepper(Page& page, const Rect& place, const Setting& setting, bool rests) {
    const Rect rect = page.on_ledge(place);
    page.stepper(rect, setting.icon, {setting.most, setting.now}, rests ? Button::kNone : setting.less,
                 setting.more, page.named(setting.key), page.right_to_left());
    page.label({rect.x - 6.0F, rect.bottom() + kBelow, rect.width + 12.0F, label_height(page)},
               page.t(setting.key), rests ? design::kRestingWords : design::kSlip);
}

int add_round(Page& page, const Rect& place, Icon icon, Button button, const char* key, float label_width,
              int value) {
    const Rect rect = page.on_ledge(place);
    const int target = page.token(rect, Look::kToken, button, page.named(key), value, icon, false);
    constexpr float kEdge = 14.0F;
    const float x =
        std::clamp(rect.centre().x - 0.5F * label_width, kEdge, page.width() - kEdge - label_width);
    page.label({x, rect.bottom() + kBelow, label_width, label_height(page)}, page.t(key));
    return target;
}

void add_choice(Page& page, const Rect& place, const LedgeChoice& choice, float name_height, float spread) {
    const Rect rect = page.on_ledge(place);
    const int target = page.token(rect, Look::kToken, choice.button, page.named(choice.key), choice.value,
                                  choice.icon, false);
    if (choice.chosen) page.say_chosen();
    page.words({rect.x - spread, rect.bottom() + kBelow, rect.width + 2.0F * spread, name_height},
               {.text = page.t(choice.key),
                .type = design::kLabel.bold_if(choice.chosen),
                .align = ui::Align::kCentre});
    if (!choice.chosen) return;
    ui::Sketch bar;
    bar.add(ui::Box{{0.0F, 0.0F, 52.0F, 5.0F}, 3.0F, ui::Fill::flat(design::kAmber)});
    page.sprite({rect.centre().x - 26.0F, rect.y - 10.0F, 52.0F, 5.0F}, std::move(bar));
    ui::Sketch tick;
    tick.add(ui::Ellipse{{0.0F, 0.0F, 26.0F, 26.0F}, ui::Fill::flat(design::kNight)});
    add_icon(tick, Icon::kCheck, {5.0F, 5.0F}, 16.0F, design::kAmber);
    page.sprite({rect.right() - 20.0F, rect.y - 8.0F, 26.0F, 26.0F}, std::move(tick), target);
}

void add_step_caption(Page& page, const std::string& text, float wide, float beside) {
    const float y = ledge_top(page);
    if (page.shape() == Shape::kWide) {
        page.words(page.on_ledge({34.0F, y + 94.0F, wide, 36.0F + growth(page).caption}),
                   {.text = text, .type = design::kName, .align = along_ledge(page)});
        return;
    }
    const bool tall = page.is_tall();
    page.words(page.on_ledge({beside, y + (tall ? 30.0F : 28.0F), page.width() - 32.0F - beside,
                              (tall ? 84.0F : 44.0F) + growth(page).caption}),
               {.text = text, .type = design::bold(tall ? 32.0F : 30.0F, 42.0F), .align = along_ledge(page)});
}

Rect add_paper(Page& page, const Rect& most, const std::vector<Words>& lines) {
    constexpr float kMargin = 20.0F;
    constexpr float kAbove = 12.0F;
    constexpr float kBetween = 4.0F;
    const float wide = most.width - 2.0F * kMargin;
    const FittedLines fitted = page.fitted(lines, {wide, most.height - 2.0F * kAbove}, kBetween);
    const Rect rect{most.x, most.y, most.width, std::min(most.height, fitted.height + 2.0F * kAbove)};
    page.card(rect, design::kHanji, design::kHanji);
    page.fitted_words({rect.x + kMargin, rect.y + kAbove, wide, rect.height - 2.0F * kAbove}, fitted);
    return rect;
}

void add_hand_pad(Page& page) {
    // Directly above the ledge and arranged as on a keyboard, because a cross would not fit the lower half.
    const float edge = page.is_tall() ? 24.0F : 32.0F;
    const Rect pad = page.mirrored({page.width() - edge - 264.0F, ledge_top(page) - 172.0F, 264.0F, 164.0F});
    const bool out_is_right = !page.view().state.comfort.left_hand;
    page.token({pad.x + 92.0F, pad.y, 80.0F, 76.0F}, Look::kToken, Button::kHandUp, page.named("ctl.up"), 0,
               Icon::kUp, false, true);
    page.token({pad.x, pad.y + 88.0F, 80.0F, 76.0F}, Look::kToken, Button::kHandLeft,
               page.named(out_is_right ? "ctl.in" : "ctl.out"), 0, Icon::kLeft, false, true);
    page.token({pad.x + 184.0F, pad.y + 88.0F, 80.0F, 76.0F}, Look::kToken, Button::kHandRight,
               page.named(out_is_right ? "ctl.out" : "ctl.in"), 0, Icon::kRight, false, true);
    page.token({pad.x + 92.0F, pad.y + 88.0F, 80.0F, 76.0F}, Look::kToken, Button::kHandDown,
               page.named("ctl.down"), 0, Icon::kDown, false, true);
}

}  // namespace onggi::screens

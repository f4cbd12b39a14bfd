// Attract: the wheel throws by itself, and each language says in its own words that one may begin. Choose:
// all pots on one shelf at one scale.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "game/screens/screens.h"

namespace onggi::screens {
namespace {

using ui::Rect;

constexpr ui::Colour kClear = design::kNight.with_alpha(0.0F);

// What waits for the next visitor is large already, whatever the one before wished: it keeps its size.
// "Touch to begin" in every language at equal size, in the configuration's order.
void begin_lines(Page& page, Rect rect, float size, ui::Align align, float gap) {
    const int count = static_cast<int>(page.view().languages->size());
    for (int place = 0; place < count; ++place) {
        const Words words{.text = page.language(place).shown("attract.touch"),
                          .type = design::serif(size, std::round(1.34F * size)),
                          .colour = design::kWhiteSlip,
                          .align = align == ui::Align::kStart && page.language(place).right_to_left()
                                       ? ui::Align::kEnd
                                       : align,
                          .language = place};
        const float used = page.fixed_words(rect, words);
        rect.y += used + gap;
        rect.height -= used + gap;
    }
    if (align != ui::Align::kStart) return;
    page.box({rect.x, rect.y + 10.0F, 56.0F, 5.0F},
             {design::kAmber, design::kAmber, design::kAmber, design::kAmber});
    rect.y += 40.0F;
    for (int place = 0; place < std::min(2, count); ++place) {
        const float used = page.fixed_words(
            {rect.x, rect.y, rect.width, 84.0F},
            {.text = page.language(place).shown("attract.line"),
             .type = design::kLine,
             .colour = design::kSlip3,
             .align = page.language(place).right_to_left() ? ui::Align::kEnd : ui::Align::kStart,
             .language = place});
        rect.y += used;
    }
}

// That nobody's pot is being made: there is room for one language at a time, so each has its turn.
void wheel_shows(Page& page, const Rect& rect) {
    const int place = page.view().attract_turn % static_cast<int>(page.view().languages->size());
    page.words(rect, {.text = page.language(place).shown("attract.auto"),
                      .type = design::kLine,
                      .colour = design::kSlip3,
                      .align = page.language(place).right_to_left() ? ui::Align::kEnd : ui::Align::kStart,
                      .language = place});
}

// What it is, when and where from, and how high, in one language.
void heritage_label(Page& page, const Exhibit& exhibit, const Rect& rect, int language) {
    const kiosk::Language& tongue = page.language(language);
    const float name =
        page.fixed_words({rect.x, rect.y, rect.width, 38.0F}, {.text = tongue.shown(exhibit.name_key),
                                                               .type = design::bold(30.0F, 38.0F),
                                                               .align = ui::Align::kCentre,
                                                               .language = language});
    const std::string text =
        fmt::format("{}\n{} \u00b7 {}", tongue.shown(exhibit.museum_key), tongue.shown(exhibit.date_key),
                    page.whole_mm(exhibit.height_mm, language));
    page.fixed_words({rect.x, rect.y + name, rect.width, rect.height - name}, {.text = text,
                                                                               .type = design::kLabel,
                                                                               .colour = design::kSlip2,
                                                                               .align = ui::Align::kCentre,
                                                                               .language = language});
}

// In every language side by side, as far as there is room; in a narrow picture one after the other.
void heritage_labels(Page& page, const Exhibit& exhibit, float y) {
    constexpr float kHigh = 104.0F;
    constexpr float kGap = 16.0F;
    const int count = static_cast<int>(page.view().languages->size());
    if (page.shape() != Shape::kWide) {
        heritage_label(page, exhibit, {40.0F, y, page.width() - 80.0F, kHigh},
                       page.view().attract_turn % count);
        return;
    }
    const int columns = std::min(count, 3);
    const float wide =
        (page.width() - 64.0F - kGap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
    for (int i = 0; i < columns; ++i) {
        const float x = 32.0F + (wide + kGap) * static_cast<float>(i);
        heritage_label(page, exhibit, {x, y, wide, kHigh}, i);
    }
}

void attract_heritage(Page& page, const Exhibit& exhibit) {
    const float width = page.width();
    const float height = page.height();
    const bool wide = page.shape() == Shape::kWide;
    const float shelf_y = page.by_shape(556.0F, 428.0F, 780.0F);
    const vec2 foot(wide ? 0.64F * width : 0.5F * width, shelf_y + 8.0F);
    page.museum({foot.x, 0.42F * height}, {0.46F * width, 0.62F * height}, 0.26F);
    page.shelf(shelf_y, 40.0F);
    page.down({0.0F, shelf_y + 40.0F, width, height - shelf_y - 40.0F}, ui::hex(0x1a120c), ui::hex(0x241a13));
    const float most = page.by_shape(460.0F, 340.0F, 560.0F);
    const float scale = std::min(1.58F, most / static_cast<float>(exhibit.height_mm));
    page.keep_clear(page.turning_pot(exhibit.shape, finish::glaze_at(exhibit.glaze), scale, foot));
    if (wide) {
        begin_lines(page, {64.0F, 80.0F, 330.0F, 440.0F}, 50.0F, ui::Align::kStart, 22.0F);
    } else {
        const bool tall = page.is_tall();
        begin_lines(page, {50.0F, tall ? 960.0F : 592.0F, width - 100.0F, tall ? 250.0F : 172.0F},
                    tall ? 50.0F : 40.0F, ui::Align::kCentre, 0.0F);
    }
    heritage_labels(page, exhibit, shelf_y + 48.0F);
}

}  // namespace

void draw_attract(Page& page) {
    const View& view = page.view();
    if (view.wall) return draw_wall(page);
    const int exhibit = view.attract_exhibit;
    if (exhibit >= 0 && exhibit < static_cast<int>(view.exhibits->size())) {
        attract_heritage(page, (*view.exhibits)[static_cast<std::size_t>(exhibit)]);
        return;
    }
    const float width = page.width();
    const float height = page.height();
    const auto night = [](float alpha) { return design::kNight.with_alpha(alpha); };
    page.scene_ends();
    if (page.shape() == Shape::kWide) {
        page.across({0.0F, 0.0F, 0.24F * width, height}, night(0.94F), night(0.88F));
        page.across({0.24F * width, 0.0F, 0.18F * width, height}, night(0.88F), night(0.45F));
        page.across({0.42F * width, 0.0F, 0.14F * width, height}, night(0.45F), kClear);
        page.down({0.0F, 0.7F * height, width, 0.3F * height}, kClear, night(0.55F));
        begin_lines(page, {64.0F, 128.0F, 400.0F, 400.0F}, 50.0F, ui::Align::kStart, 26.0F);
        wheel_shows(page, {64.0F, height - 104.0F, 400.0F, 80.0F});
    } else if (page.is_tall()) {
        page.down({0.0F, 0.0F, width, 0.22F * height}, night(0.30F), kClear);
        page.down({0.0F, 0.56F * height, width, 0.17F * height}, kClear, night(0.94F));
        page.down({0.0F, 0.73F * height, width, 0.27F * height}, night(0.94F), night(1.0F));
        begin_lines(page, {50.0F, 980.0F, width - 100.0F, 270.0F}, 58.0F, ui::Align::kCentre, 8.0F);
    } else {
        page.down({0.0F, 0.0F, width, 0.25F * height}, night(0.25F), kClear);
        page.down({0.0F, 0.52F * height, width, 0.18F * height}, kClear, night(0.92F));
        page.down({0.0F, 0.70F * height, width, 0.30F * height}, night(0.92F), night(0.97F));
        begin_lines(page, {60.0F, 548.0F, width - 120.0F, 200.0F}, 48.0F, ui::Align::kCentre, 2.0F);
    }
}

namespace {

struct Choice {
    std::string name;
    std::string second;
    std::string third;
    std::string size;
    const Exhibit* exhibit = nullptr;
};

std::string size_of(const Page& page, const Exhibit& exhibit) {
    const auto whole = [](double value) { return fmt::format("{:.0f}", value); };
    if (exhibit.diameter_mm <= 0.0) return page.t("dim.high", page.whole_mm(exhibit.height_mm));
    return page.measure(whole(exhibit.height_mm) + " \u00d7 " + whole(exhibit.diameter_mm), "unit.mm");
}

void draw_card(Page& page, const Rect& card, const Choice& choice, int index) {
    const bool free = choice.exhibit == nullptr;
    page.card_target(card, free, free ? kiosk::Button::kFree : kiosk::Button::kTarget, free ? 0 : index - 1,
                     choice.name);
    const Rect inner{card.x + 11.0F, card.y + 11.0F, card.width - 22.0F, card.height - 18.0F};
    std::vector<Words> lines{
        {.text = choice.name, .type = design::bold(28.0F, 34.0F), .colour = design::kInk},
        {.text = choice.second, .colour = free ? design::kInk : design::kInk2},
        {.text = choice.third, .colour = design::kInk2}};
    if (choice.exhibit != nullptr && !choice.exhibit->part.empty()) {
        const std::string& part = choice.exhibit->part;
        lines.push_back(
            {.text = part == "1/2" ? page.t("choose.half") : page.t("choose.part", page.digits(part)),
             .colour = design::kInk2});
    }
    lines.push_back({.text = choice.size, .type = design::bold(26.0F, 34.0F), .colour = design::kInk});
    std::erase_if(lines, [](const Words& words) { return words.text.empty(); });
    FittedLines fitted = page.fitted(std::move(lines), {inner.width, inner.height - 8.0F});
    // A size stands at the card's foot, whatever is above it.
    if (choice.exhibit != nullptr) {
        const float room = fitted.heights.back();
        page.fixed_words({inner.x, inner.bottom() - room, inner.width, room + 2.0F}, fitted.lines.back());
        fitted.lines.pop_back();
    }
    page.fitted_words(inner, fitted);
}

constexpr float kAboutSide = design::kLeastTarget;
constexpr float kAboutRoom = kAboutSide + 10.0F;

// Opens the pot's own card.
void about(Page& page, const Rect& rect, const Choice& choice, int index) {
    if (choice.exhibit == nullptr || !choice.exhibit->card) return;
    page.token(rect, Look::kToken, kiosk::Button::kCard, page.t("card.about"), index - 1, Icon::kAbout,
               false);
}

std::vector<Choice> all_choices(const Page& page) {
    std::vector<Choice> choices{{page.t("choose.free"), page.t("choose.free2"), "", "", nullptr}};
    for (const Exhibit& exhibit : *page.view().exhibits) {
        choices.push_back({page.t(exhibit.name_key), page.t(exhibit.museum_key), page.t(exhibit.date_key),
                           size_of(page, exhibit), &exhibit});
    }
    return choices;
}

// As many of the choices as have room beside each other, all at one scale.
struct ShownChoices {
    std::vector<Choice> all;
    int count = 0;
    int first = 0;
    float scale = 1.0F;  // u/mm

    [[nodiscard]] bool is_paged() const { return count < static_cast<int>(all.size()); }
    [[nodiscard]] const Choice& at(int place) const { return all[static_cast<std::size_t>(first + place)]; }
};

// Gives where a finger finds it, however flat a bowl is.
Rect choice_pot(Page& page, const Choice& choice, float scale, vec2 foot) {
    const bool free = choice.exhibit == nullptr;
    const Rect rect =
        page.pot(free ? pot::fresh_lump() : choice.exhibit->shape,
                 free ? finish::wet_clay() : finish::glaze_at(choice.exhibit->glaze), scale, foot);
    page.keep_clear(rect);
    const float wide = std::max(rect.width, design::kLeastTarget);
    const float high = std::max(rect.height, design::kLeastTarget);
    return {foot.x - 0.5F * wide, rect.bottom() - high, wide, high};
}

void choices_in_rows(Page& page, const ShownChoices& shown) {
    const float width = page.width();
    const float top = 116.0F;
    const float step = std::min(shown.count < 4 ? 350.0F : 266.0F,
                                (page.height() - top - 100.0F) / static_cast<float>(shown.count));
    for (int i = 0; i < shown.count; ++i) {
        const float y = top + step * static_cast<float>(i);
        const Rect shelf = page.mirrored({24.0F, y + step - 30.0F, 216.0F, 14.0F});
        page.down(shelf, design::kShelf, design::kShelfEdge);
        const Rect touched = choice_pot(page, shown.at(i), shown.scale, {shelf.centre().x, shelf.y + 5.0F});
        draw_card(page, page.mirrored({256.0F, y, width - 256.0F - 24.0F - kAboutRoom, step - 14.0F}),
                  shown.at(i), shown.first + i);
        page.also_touched_at(touched);
        about(page,
              page.mirrored({width - 24.0F - kAboutSide, y + 0.5F * (step - 14.0F - kAboutSide), kAboutSide,
                             kAboutSide}),
              shown.at(i), shown.first + i);
    }
}

void choices_on_shelf(Page& page, const ShownChoices& shown) {
    const float shelf_y = page.lower_by() + (page.is_tall()     ? 606.0F
                                             : page.is_square() ? (page.is_low() ? 346.0F : 306.0F)
                                                                : 340.0F);
    const float card_top = shelf_y + 40.0F;
    const float card_height = page.height() - card_top - 84.0F - (page.is_low() ? kAboutRoom : 0.0F);
    const float gap = 10.0F;
    const float card_width =
        (page.width() - 48.0F - gap * static_cast<float>(shown.count - 1)) / static_cast<float>(shown.count);
    page.shelf(shelf_y, 30.0F);
    for (int i = 0; i < shown.count; ++i) {
        const Rect card = page.mirrored(
            {24.0F + static_cast<float>(i) * (card_width + gap), card_top, card_width, card_height});
        const Rect touched = choice_pot(page, shown.at(i), shown.scale, {card.centre().x, shelf_y + 9.0F});
        draw_card(page, card, shown.at(i), shown.first + i);
        page.also_touched_at(touched);
        // On the shelf beside its pot, or brought low below its card.
        const float about_y = page.is_low() ? card.bottom() + 8.0F : shelf_y - kAboutSide - 2.0F;
        about(page, {card.right() - kAboutSide, about_y, kAboutSide, kAboutSide}, shown.at(i),
              shown.first + i);
    }
}

void paging_tokens(Page& page, const ShownChoices& shown, float y) {
    const bool rtl = page.right_to_left();
    page.token(page.mirrored({222.0F, y, 84.0F, 60.0F}), Look::kToken, kiosk::Button::kShelfBefore,
               page.t("choose.before"), std::max(0, shown.first - shown.count),
               rtl ? Icon::kRight : Icon::kLeft, false);
    page.token(page.mirrored({322.0F, y, 84.0F, 60.0F}), Look::kToken, kiosk::Button::kShelfNext,
               page.t("choose.next"),
               std::min(shown.first + shown.count, static_cast<int>(shown.all.size()) - shown.count),
               rtl ? Icon::kLeft : Icon::kRight, false);
}

// The scale, drawn and in words; where the token of languages is brought low, it makes room.
void scale_bar(Page& page, const ShownChoices& shown, float foot_y) {
    const bool tall = page.is_tall();
    const bool is_on_top = tall && page.is_low();
    const float scale_y = is_on_top ? 30.0F : foot_y;
    const float scale_right = page.width() - 32.0F - (page.is_low() && !tall ? 170.0F : 0.0F);
    const float bar = 100.0F * shown.scale;
    const Rect bar_rect = page.mirrored({scale_right - bar, scale_y + 22.0F, bar, 14.0F});
    ui::Sketch sketch;
    sketch.add(ui::Shape{.path = fmt::format("M1.5 1.5 V12.5 H{0:.1f} V1.5", bar - 1.5F),
                         .stroke = design::kSlip2,
                         .stroke_width = 3.0F});
    page.sprite(bar_rect, std::move(sketch));
    page.words(page.mirrored({scale_right - bar - 132.0F, scale_y + 8.0F, 120.0F, 36.0F}),
               {.text = page.measure("100", "unit.mm"),
                .type = design::kNote,
                .colour = design::kSlip2,
                .align = ui::Align::kEnd});
    const float note_width = scale_right - bar - 132.0F - 220.0F;
    if (page.text_scale() < 1.9F && !shown.is_paged() && note_width > 200.0F) {
        page.words(page.mirrored({212.0F, foot_y - (note_width < 420.0F ? 6.0F : -8.0F), note_width,
                                  note_width < 420.0F ? 68.0F : 36.0F}),
                   {.text = page.t("choose.scale"),
                    .type = design::kNote,
                    .colour = design::kSlip2,
                    .align = ui::Align::kEnd});
    }
}

}  // namespace

void draw_choose(Page& page) {
    const float width = page.width();
    const float height = page.height();
    ShownChoices shown{.all = all_choices(page)};
    page.museum({0.5F * width, 0.4F * height}, {0.6F * width, 0.5F * height}, 0.20F);
    page.words(page.mirrored({32.0F, 24.0F, width - 260.0F, 66.0F}),
               {.text = page.t("choose.title"), .type = design::kTitle, .colour = design::kSlip});
    const float foot_y = height - 77.0F;
    page.languages_token({width - 182.0F, foot_y, 150.0F, 60.0F});
    // Brought low, a tall screen has its cards side by side, as the others always have.
    const bool in_rows = page.is_tall() && !page.is_low();
    // Fewer with the largest text or brought low, and a way to the others.
    const bool is_narrow = page.is_square() || page.text_scale() > 1.9F || page.is_low();
    const int all = static_cast<int>(shown.all.size());
    shown.count = std::min(all, is_narrow ? 3 : 4);
    shown.first = std::clamp(page.view().state.shelf_first, 0, all - shown.count);
    shown.scale = in_rows ? 0.52F : 0.58F;
    if (in_rows) {
        choices_in_rows(page, shown);
    } else {
        choices_on_shelf(page, shown);
    }
    page.back_token(page.mirrored({32.0F, foot_y, 170.0F, 60.0F}));
    if (shown.is_paged()) paging_tokens(page, shown, foot_y);
    scale_bar(page, shown, foot_y);
}

}  // namespace onggi::screens

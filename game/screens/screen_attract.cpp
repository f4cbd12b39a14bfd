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

// "Touch to begin" in every language at equal size, in the configuration's order.
void begin_lines(Page& page, Rect rect, float size, ui::Align align, float gap) {
    const int count = static_cast<int>(page.view().languages->size());
    for (int place = 0; place < count; ++place) {
        const Words words{.text = page.language(place).shown("attract.touch"),
                          .size = size,
                          .line = std::round(1.34F * size),
                          .title = true,
                          .colour = design::kWhiteSlip,
                          .align = align == ui::Align::kStart && page.language(place).right_to_left()
                                       ? ui::Align::kEnd
                                       : align,
                          .language = place,
                          .least_size = 40.0F};
        const float used = page.words(rect, words);
        rect.y += used + gap;
        rect.height -= used + gap;
    }
    if (align != ui::Align::kStart) return;
    page.box({rect.x, rect.y + 10.0F, 56.0F, 5.0F},
             {design::kAmber, design::kAmber, design::kAmber, design::kAmber});
    rect.y += 40.0F;
    for (int place = 0; place < std::min(2, count); ++place) {
        const float used =
            page.words({rect.x, rect.y, rect.width, 84.0F},
                       {.text = page.language(place).shown("attract.line"),
                        .size = 28.0F,
                        .line = 40.0F,
                        .colour = design::kSlip3,
                        .align = page.language(place).right_to_left() ? ui::Align::kEnd : ui::Align::kStart,
                        .language = place});
        rect.y += used;
    }
}

void heritage_label(Page& page, const Exhibit& exhibit, float y) {
    const auto both = [&](const std::string& key) {
        std::string text = page.language(0).shown(key);
        if (page.view().languages->size() > 1) text += " \u00b7 " + page.language(1).shown(key);
        return text;
    };
    const Rect rect{0.5F * page.width() - 350.0F, y, 700.0F, 40.0F};
    page.words(rect, {.text = both(exhibit.name_key),
                      .size = 30.0F,
                      .line = 40.0F,
                      .bold = true,
                      .align = ui::Align::kCentre,
                      .language = 0});
    page.words(
        {rect.x, y + 40.0F, rect.width, 36.0F},
        {.text = fmt::format("{} \u00b7 {} \u00b7 {:.0f} mm", page.language(0).shown(exhibit.museum_key),
                             page.language(0).shown(exhibit.date_key), exhibit.height_mm),
         .size = 26.0F,
         .line = 36.0F,
         .colour = design::kSlip2,
         .align = ui::Align::kCentre,
         .language = 0});
}

void attract_heritage(Page& page, const Exhibit& exhibit) {
    const float width = page.width();
    const float height = page.height();
    const bool wide = page.shape() == Shape::kWide;
    const float shelf_y = wide ? 580.0F : page.shape() == Shape::kSquare ? 460.0F : 790.0F;
    const vec2 foot(wide ? 0.64F * width : 0.5F * width, shelf_y + 8.0F);
    page.museum({foot.x, 0.42F * height}, {0.46F * width, 0.62F * height}, 0.26F);
    page.shelf(shelf_y, 40.0F);
    page.down({0.0F, shelf_y + 40.0F, width, height - shelf_y - 40.0F}, ui::hex(0x1a120c), ui::hex(0x241a13));
    const float most = wide ? 480.0F : page.shape() == Shape::kSquare ? 350.0F : 560.0F;
    const float scale = std::min(1.58F, most / static_cast<float>(exhibit.height_mm));
    page.keep_clear(page.pot(exhibit.shape, finish::glaze_at(exhibit.glaze), scale, foot));
    if (wide) {
        begin_lines(page, {64.0F, 100.0F, 330.0F, 440.0F}, 50.0F, ui::Align::kStart, 26.0F);
    } else {
        const bool tall = page.shape() == Shape::kTall;
        begin_lines(page, {50.0F, tall ? 960.0F : 592.0F, width - 100.0F, tall ? 250.0F : 172.0F},
                    tall ? 50.0F : 40.0F, ui::Align::kCentre, 0.0F);
    }
    heritage_label(page, exhibit, wide ? 630.0F : page.shape() == Shape::kSquare ? 504.0F : 850.0F);
}

}  // namespace

void draw_attract(Page& page) {
    const View& view = page.view();
    const int exhibit = view.attract_exhibit;
    if (exhibit >= 0 && exhibit < static_cast<int>(view.exhibits->size())) {
        attract_heritage(page, (*view.exhibits)[static_cast<std::size_t>(exhibit)]);
        return;
    }
    const float width = page.width();
    const float height = page.height();
    const auto night = [](float alpha) { return design::kNight.with_alpha(alpha); };
    if (page.shape() == Shape::kWide) {
        page.across({0.0F, 0.0F, 0.24F * width, height}, night(0.94F), night(0.88F));
        page.across({0.24F * width, 0.0F, 0.18F * width, height}, night(0.88F), night(0.45F));
        page.across({0.42F * width, 0.0F, 0.14F * width, height}, night(0.45F), kClear);
        page.down({0.0F, 0.7F * height, width, 0.3F * height}, kClear, night(0.55F));
        begin_lines(page, {64.0F, 128.0F, 400.0F, 400.0F}, 50.0F, ui::Align::kStart, 26.0F);
    } else if (page.shape() == Shape::kTall) {
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
    if (exhibit.diameter_mm <= 0.0)
        return page.t("dim.high", page.measure(whole(exhibit.height_mm), "unit.mm"));
    return page.measure(whole(exhibit.height_mm) + " \u00d7 " + whole(exhibit.diameter_mm), "unit.mm");
}

// A lump of one kilogram: about as wide as it is high.
const PotShape& lump() {
    static const PotShape shape{.outside = {{62.0F, 0.0F},
                                            {67.0F, 8.0F},
                                            {68.0F, 24.0F},
                                            {66.0F, 42.0F},
                                            {60.0F, 62.0F},
                                            {50.0F, 80.0F},
                                            {34.0F, 92.0F},
                                            {16.0F, 98.0F},
                                            {0.5F, 99.0F}},
                                .inside = {}};
    return shape;
}

void draw_card(Page& page, const Rect& card, const Choice& choice, int index) {
    const bool free = choice.exhibit == nullptr;
    page.card_target(card, free, free ? kiosk::Button::kFree : kiosk::Button::kTarget, free ? 0 : index - 1,
                     choice.name);
    const Rect inner{card.x + 11.0F, card.y + 14.0F, card.width - 22.0F, card.height - 24.0F};
    float y = inner.y;
    // On a narrow card the size takes two lines.
    const float size_width =
        page.words_width({.text = choice.size, .size = 26.0F, .line = 34.0F, .bold = true});
    const float size_room = choice.size.empty() ? 0.0F : size_width > inner.width ? 74.0F : 40.0F;
    const auto line = [&](const std::string& text, float size, float height, bool bold,
                          const ui::Colour& colour) {
        if (text.empty()) return;
        const float room = inner.bottom() - size_room - y;
        y += page.words({inner.x, y, inner.width, std::max(room, height)},
                        {.text = text, .size = size, .line = height, .bold = bold, .colour = colour}, true);
    };
    line(choice.name, 28.0F, 34.0F, true, design::kInk);
    y += 2.0F;
    line(choice.second, 26.0F, 32.0F, false, free ? design::kInk : design::kInk2);
    line(choice.third, 26.0F, 32.0F, false, design::kInk2);
    if (choice.exhibit != nullptr && choice.exhibit->half_size)
        line(page.t("choose.half"), 26.0F, 32.0F, false, design::kInk2);
    if (!choice.size.empty()) {
        page.words({inner.x, inner.bottom() - size_room + 4.0F, inner.width, size_room - 2.0F},
                   {.text = choice.size, .size = 26.0F, .line = 34.0F, .bold = true, .colour = design::kInk},
                   true);
    }
}

}  // namespace

void draw_choose(Page& page) {
    const View& view = page.view();
    const float width = page.width();
    const float height = page.height();
    const bool tall = page.shape() == Shape::kTall;
    const bool square = page.shape() == Shape::kSquare;
    std::vector<Choice> choices{{page.t("choose.free"), page.t("choose.free2"), "", "", nullptr}};
    for (const Exhibit& exhibit : *view.exhibits) {
        choices.push_back({page.t(exhibit.name_key), page.t(exhibit.museum_key), page.t(exhibit.date_key),
                           size_of(page, exhibit), &exhibit});
    }
    page.museum({0.5F * width, 0.4F * height}, {0.6F * width, 0.5F * height}, 0.20F);
    page.words(page.mirrored({32.0F, 24.0F, width - 260.0F, 66.0F}), {.text = page.t("choose.title"),
                                                                      .size = 46.0F,
                                                                      .line = 62.0F,
                                                                      .title = true,
                                                                      .colour = design::kSlip,
                                                                      .least_size = 40.0F});
    page.languages_token();

    const auto count = static_cast<int>(choices.size());
    const float scale = tall ? 0.52F : square ? 0.60F : 0.76F;
    const auto pot = [&](const Choice& choice, vec2 foot) {
        const bool free = choice.exhibit == nullptr;
        const Rect rect =
            page.pot(free ? lump() : choice.exhibit->shape,
                     free ? finish::wet_clay() : finish::glaze_at(choice.exhibit->glaze), scale, foot);
        page.keep_clear(rect);
    };
    if (tall) {
        const float top = 116.0F;
        const float step = std::min(206.0F, (height - top - 100.0F) / static_cast<float>(count));
        for (int i = 0; i < count; ++i) {
            const float y = top + step * static_cast<float>(i);
            const Rect shelf = page.mirrored({24.0F, y + step - 30.0F, 216.0F, 14.0F});
            page.down(shelf, design::kShelf, design::kShelfEdge);
            pot(choices[static_cast<std::size_t>(i)], {shelf.centre().x, shelf.y + 5.0F});
            draw_card(page, page.mirrored({256.0F, y, width - 256.0F - 24.0F, step - 14.0F}),
                      choices[static_cast<std::size_t>(i)], i);
        }
    } else {
        const float shelf_y = square ? 330.0F : 340.0F;
        const float card_top = shelf_y + 40.0F;
        const float card_height = height - card_top - 84.0F;
        const float gap = 10.0F;
        const float card_width =
            (width - 48.0F - gap * static_cast<float>(count - 1)) / static_cast<float>(count);
        page.shelf(shelf_y, 30.0F);
        for (int i = 0; i < count; ++i) {
            const Rect card = page.mirrored(
                {24.0F + static_cast<float>(i) * (card_width + gap), card_top, card_width, card_height});
            pot(choices[static_cast<std::size_t>(i)], {card.centre().x, shelf_y + 9.0F});
            draw_card(page, card, choices[static_cast<std::size_t>(i)], i);
        }
    }
    const float foot_y = height - 77.0F;
    page.token(page.mirrored({32.0F, foot_y, 170.0F, 60.0F}), Look::kOutline, kiosk::Button::kBack,
               page.t("ctl.back"), 0, page.right_to_left() ? Icon::kRight : Icon::kLeft);
    // The scale, drawn and in words.
    const float bar = 100.0F * scale;
    const Rect bar_rect = page.mirrored({width - 32.0F - bar, foot_y + 22.0F, bar, 14.0F});
    ui::Sketch sketch;
    sketch.add(ui::Shape{.path = fmt::format("M1.5 1.5 V12.5 H{0:.1f} V1.5", bar - 1.5F),
                         .stroke = design::kSlip2,
                         .stroke_width = 3.0F});
    page.sprite(bar_rect, std::move(sketch));
    page.words(page.mirrored({width - 32.0F - bar - 132.0F, foot_y + 8.0F, 120.0F, 36.0F}),
               {.text = page.measure("100", "unit.mm"),
                .size = 26.0F,
                .line = 34.0F,
                .colour = design::kSlip2,
                .align = ui::Align::kEnd});
    const float note_width = width - 32.0F - bar - 132.0F - 220.0F;
    if (page.text_scale() < 1.9F && note_width > 200.0F) {
        page.words(page.mirrored({212.0F, foot_y - (note_width < 420.0F ? 6.0F : -8.0F), note_width,
                                  note_width < 420.0F ? 68.0F : 36.0F}),
                   {.text = page.t("choose.scale"),
                    .size = 26.0F,
                    .line = 34.0F,
                    .colour = design::kSlip2,
                    .align = ui::Align::kEnd});
    }
}

}  // namespace onggi::screens

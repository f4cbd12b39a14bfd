// The choice of a pot: free throwing, or a museum's pot as the target, with a card about it.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "game/visit/flow/turn.h"

namespace onggi::visit {
namespace {

using ui::Rect;

struct Choice {
    std::string key;  // of the name
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

// Fits the words of a card into the largest size that it may have; the last line is the pot's size.
FittedLines card_words(Page& page, const Choice& choice, vec2 card) {
    const bool free = choice.exhibit == nullptr;
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
    return page.fitted(std::move(lines), {card.x - 22.0F, card.y - 26.0F});
}

// The height of a card around its words.
float card_height(Page& page, const Choice& choice, vec2 most) {
    constexpr float kAround = 28.0F;
    return std::clamp(card_words(page, choice, most).height + kAround, design::kLeastTarget, most.y);
}

void draw_card(Page& page, const Rect& card, const Choice& choice, int index) {
    const bool free = choice.exhibit == nullptr;
    page.card_target(card, free, free ? Button::kFree : Button::kTarget, free ? 0 : index - 1,
                     page.named(choice.key));
    const Rect inner{card.x + 11.0F, card.y + 11.0F, card.width - 22.0F, card.height - 18.0F};
    page.fitted_words(inner, card_words(page, choice, {card.width, card.height}));
}

constexpr float kAboutSide = design::kLeastTarget;
constexpr float kAboutRoom = kAboutSide + 10.0F;

// Adds the button that opens the pot's card.
void about(Page& page, const Rect& rect, const Choice& choice, int index) {
    if (choice.exhibit == nullptr || !choice.exhibit->card) return;
    page.token(rect, Look::kToken, Button::kCard, page.named("card.about"), index - 1, Icon::kAbout, false);
}

std::vector<Choice> all_choices(const Page& page) {
    std::vector<Choice> choices{
        {"choose.free", page.t("choose.free"), page.t("choose.free2"), "", "", nullptr}};
    for (const Exhibit& exhibit : *page.view().exhibits) {
        choices.push_back({exhibit.name_key, page.t(exhibit.name_key), page.t(exhibit.museum_key),
                           page.t(exhibit.date_key), size_of(page, exhibit), &exhibit});
    }
    return choices;
}

// The choices that fit side by side, all at one scale.
struct ShownChoices {
    std::vector<Choice> all;
    int count = 0;
    int first = 0;
    float scale = 1.0F;  // u/mm

    [[nodiscard]] bool is_paged() const { return count < static_cast<int>(all.size()); }
    [[nodiscard]] const Choice& at(int place) const { return all[static_cast<std::size_t>(first + place)]; }
};

const pot::Section& shape_of(const Choice& choice) {
    static const pot::Section lump = pot::fresh_lump();
    return choice.exhibit == nullptr ? lump : choice.exhibit->shape;
}

// The largest scale, u/mm, at which each of the shown pots fits a box of that size.
float shared_scale(const ShownChoices& shown, vec2 box) {
    constexpr float kMost = 0.9F;
    float scale = kMost;
    for (int i = 0; i < shown.count; ++i) {
        const pot::Section& shape = shape_of(shown.at(i));
        scale = std::min({scale, box.x / (2.0F * shape.radius_mm()), box.y / (1.1F * shape.height_mm())});
    }
    return scale;
}

// Returns the pot's touch target, which is large enough even for a flat bowl.
Rect choice_pot(Page& page, const Choice& choice, float scale, vec2 foot) {
    const bool free = choice.exhibit == nullptr;
    const Rect rect = page.pot(
        shape_of(choice), free ? finish::wet_clay() : finish::glaze_at(choice.exhibit->glaze), scale, foot);
    page.keep_clear(rect);
    const float wide = std::max(rect.width, design::kLeastTarget);
    const float high = std::max(rect.height, design::kLeastTarget);
    return {foot.x - 0.5F * wide, rect.bottom() - high, wide, high};
}

void choices_in_rows(Page& page, ShownChoices& shown) {
    const float width = page.width();
    const float top = 116.0F;
    const float step = std::min(shown.count < 4 ? 350.0F : 266.0F,
                                (page.height() - top - 100.0F) / static_cast<float>(shown.count));
    shown.scale = shared_scale(shown, {190.0F, step - 44.0F});
    for (int i = 0; i < shown.count; ++i) {
        const float y = top + step * static_cast<float>(i);
        const Rect shelf = page.mirrored({24.0F, y + step - 30.0F, 216.0F, 14.0F});
        page.down(shelf, design::kShelf, design::kShelfEdge);
        const Rect touched = choice_pot(page, shown.at(i), shown.scale, {shelf.centre().x, shelf.y + 5.0F});
        // Beside the pot, around the middle of its row.
        const vec2 most{width - 256.0F - 24.0F - kAboutRoom, step - 14.0F};
        const float high = card_height(page, shown.at(i), most);
        draw_card(page, page.mirrored({256.0F, y + 0.5F * (most.y - high), most.x, high}), shown.at(i),
                  shown.first + i);
        page.also_touched_at(touched);
        about(page,
              page.mirrored({width - 24.0F - kAboutSide, y + 0.5F * (step - 14.0F - kAboutSide), kAboutSide,
                             kAboutSide}),
              shown.at(i), shown.first + i);
    }
}

void choices_on_shelf(Page& page, ShownChoices& shown) {
    const float least_y = page.lower_by() + (page.is_tall()     ? 606.0F
                                             : page.is_square() ? (page.is_low() ? 346.0F : 306.0F)
                                                                : 340.0F);
    const float bottom = page.height() - 84.0F - (page.is_low() ? kAboutRoom : 0.0F);
    const float gap = 10.0F;
    const float card_width =
        (page.width() - 48.0F - gap * static_cast<float>(shown.count - 1)) / static_cast<float>(shown.count);
    // The cards hang below the shelf, each as high as its words, and the pots have the room above the
    // highest.
    const vec2 most{card_width, bottom - least_y - 40.0F};
    std::vector<float> heights;
    for (int i = 0; i < shown.count; ++i)
        heights.push_back(card_height(page, shown.at(i), most));
    const float card_top = bottom - *std::max_element(heights.begin(), heights.end());
    const float shelf_y = card_top - 40.0F;
    shown.scale = shared_scale(shown, {card_width - 2.0F * kAboutRoom, shelf_y - 96.0F});
    page.shelf(shelf_y, 30.0F);
    for (int i = 0; i < shown.count; ++i) {
        const Rect card = page.mirrored({24.0F + static_cast<float>(i) * (card_width + gap), card_top,
                                         card_width, heights[static_cast<std::size_t>(i)]});
        const Rect touched = choice_pot(page, shown.at(i), shown.scale, {card.centre().x, shelf_y + 9.0F});
        draw_card(page, card, shown.at(i), shown.first + i);
        page.also_touched_at(touched);
        // Beside its pot on the shelf, or below its card with low controls.
        const float about_y = page.is_low() ? bottom + 8.0F : shelf_y - kAboutSide - 2.0F;
        about(page, {card.right() - kAboutSide, about_y, kAboutSide, kAboutSide}, shown.at(i),
              shown.first + i);
    }
}

void paging_tokens(Page& page, const ShownChoices& shown, float y) {
    const bool rtl = page.right_to_left();
    page.token(page.mirrored({222.0F, y, 84.0F, 60.0F}), Look::kToken, Button::kShelfBefore,
               page.named("choose.before"), std::max(0, shown.first - shown.count),
               rtl ? Icon::kRight : Icon::kLeft, false);
    page.token(page.mirrored({322.0F, y, 84.0F, 60.0F}), Look::kToken, Button::kShelfNext,
               page.named("choose.next"),
               std::min(shown.first + shown.count, static_cast<int>(shown.all.size()) - shown.count),
               rtl ? Icon::kLeft : Icon::kRight, false);
}

// The scale bar with its text; makes room for the languages' token with low controls.
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

void draw_choose(Page& page) {
    const float width = page.width();
    const float height = page.height();
    ShownChoices shown{.all = all_choices(page)};
    page.museum({0.5F * width, 0.4F * height}, {0.6F * width, 0.5F * height}, 0.20F);
    page.words(page.mirrored({32.0F, 24.0F, width - 260.0F, 66.0F}),
               {.text = page.t("choose.title"), .type = design::kTitle, .colour = design::kSlip});
    const float foot_y = height - 77.0F;
    page.languages_token({width - 182.0F, foot_y, 150.0F, 60.0F});
    // A tall screen shows the cards in rows, unless the controls are low.
    const bool in_rows = page.is_tall() && !page.is_low();
    // With large text or low controls fewer choices fit; buttons page through the others.
    const bool is_narrow = page.is_square() || page.text_scale() > 1.9F || page.is_low();
    const int all = static_cast<int>(shown.all.size());
    shown.count = std::min(all, is_narrow ? 3 : 4);
    shown.first = std::clamp(page.view().state.shelf_first, 0, all - shown.count);
    if (in_rows) {
        choices_in_rows(page, shown);
    } else {
        choices_on_shelf(page, shown);
    }
    page.back_token(page.mirrored({32.0F, foot_y, 170.0F, 60.0F}));
    if (shown.is_paged()) paging_tokens(page, shown, foot_y);
    scale_bar(page, shown, foot_y);
}

const Exhibit* exhibit_of(const View& view) {
    if (view.state.card == kRelativesCard) return view.pot ? view.pot->relative.get() : nullptr;
    const auto place = static_cast<std::size_t>(view.state.card);
    return place < view.exhibits->size() ? &(*view.exhibits)[place] : nullptr;
}

std::string joined(std::initializer_list<std::string> parts) {
    std::string all;
    for (const std::string& part : parts)
        if (!part.empty()) all += (all.empty() ? "" : " \u00b7 ") + part;
    return all;
}

// Returns the lines from top to bottom: the pot's name, place and date, three lines with headings, the
// source.
std::vector<Words> lines_of(const Page& page, const Exhibit& exhibit) {
    constexpr std::array kHeads{"card.use", "card.making", "card.look"};
    constexpr std::array kKnownBy{"card.record", "card.kind", "card.general"};
    const auto language = static_cast<std::size_t>(page.view().state.comfort.language);
    std::vector<Words> lines{
        {.text = page.t(exhibit.name_key), .type = design::bold(32.0F, 38.0F), .colour = design::kInk},
        {.text =
             joined({page.t(exhibit.museum_key), page.t(exhibit.date_key), page.whole_mm(exhibit.height_mm)}),
         .colour = design::kInk2}};
    if (!exhibit.card || language >= exhibit.card->lines.size()) return lines;
    const ExhibitCard& card = *exhibit.card;
    for (std::size_t line = 0; line < kHeads.size(); ++line) {
        lines.push_back({.text = joined({page.t(kHeads[line]),
                                         page.t(kKnownBy[static_cast<std::size_t>(card.known_by[line])])}),
                         .type = design::bold(26.0F, 34.0F),
                         .colour = design::kRust});
        lines.push_back({.text = card.lines[language][line], .colour = design::kInk});
    }
    lines.push_back(
        {.text = joined({page.t("card.published", page.digits(std::to_string(card.published_points))),
                         page.t("card.drawn", page.digits(std::to_string(card.drawn_points)))}),
         .colour = design::kInk2});
    lines.push_back(
        {.text = page.t("card.source") + " \u2066" + card.source + "\u2069", .colour = design::kInk2});
    return lines;
}

void draw_card_panel(Page& page) {
    const View& view = page.view();
    const float width = page.width();
    const float height = page.height();
    const bool tall = page.is_tall();
    // Squarer pictures give the words more of the width.
    const float left = page.by_shape(0.34F, 0.26F, 1.0F);
    const float foot_y = height - 96.0F;
    const float shelf_y = tall ? 300.0F : foot_y - 50.0F;
    const Rect stage = page.mirrored({0.0F, 0.0F, left * width, shelf_y});
    page.museum({stage.centre().x, 0.5F * shelf_y}, {0.4F * width, 0.5F * height}, 0.28F);
    page.shelf(shelf_y, 30.0F);
    const Exhibit* const exhibit = exhibit_of(view);
    if (exhibit != nullptr) {
        const float scale = std::min({(stage.width - 48.0F) / (2.0F * exhibit->shape.radius_mm()),
                                      (shelf_y - 60.0F) / (exhibit->shape.height_mm() * 1.12F), 1.6F});
        page.keep_clear(page.turning_pot(exhibit->shape, finish::glaze_at(exhibit->glaze), scale,
                                         {stage.centre().x, shelf_y + 10.0F}));
        const Rect card =
            page.mirrored(tall ? Rect{24.0F, shelf_y + 44.0F, width - 48.0F, foot_y - shelf_y - 60.0F}
                               : Rect{left * width, 24.0F, (1.0F - left) * width - 32.0F, foot_y - 44.0F});
        page.card(card, design::kHanji, design::kHanji);
        const Rect inner{card.x + 22.0F, card.y + 14.0F, card.width - 44.0F, card.height - 24.0F};
        page.fitted_words(inner, page.fitted(lines_of(page, *exhibit), {inner.width, inner.height}, 2.0F));
    }
    page.back_token(page.mirrored({32.0F, foot_y + 8.0F, 190.0F, 70.0F}), Button::kCardClose);
    if (view.state.card == kRelativesCard) return;  // a pot is already shown
    page.token(page.mirrored({width - 332.0F, foot_y + 2.0F, 300.0F, 76.0F}), Look::kPrimary,
               Button::kCardThrow, page.named("card.throw"));
}

bool is_pot(const Turn& turn, int place) {
    return place >= 0 && place < turn.rules.target_count;
}

bool is_jar(const Turn& turn, int place) {
    const std::vector<int>& jars = turn.rules.jars;
    return std::find(jars.begin(), jars.end(), place) != jars.end();
}

void enter_choose(Turn& turn) {
    turn.state.shelf_first = 0;
}

void press_choose(Turn& turn, const event::Pressed& event) {
    const bool is_target = event.button == Button::kTarget && is_pot(turn, event.value);
    if (event.button == Button::kShelfBefore || event.button == Button::kShelfNext) {
        turn.state.shelf_first = std::clamp(event.value, 0, turn.rules.target_count);
    } else if (event.button == Button::kCard && is_pot(turn, event.value)) {
        turn.state.card = event.value;
        turn.lay_over(Panel::kCard);
    } else if (event.button == Button::kBack) {
        turn.end_visit();
    } else if (is_target && is_jar(turn, event.value)) {
        turn.state.throwing = {.target = event.value};
        turn.show(Screen::kJarStart);
    } else if (event.button == Button::kFree || is_target) {
        turn.show(Screen::kThrow);
        turn.put_on_clay(is_target ? std::optional<int>(event.value) : std::nullopt);
    }
}

// Touching the clay beside the cards chooses free throwing.
void take_choose(Turn& turn, const Event& event) {
    if (!std::holds_alternative<event::ClayTouched>(event)) return;
    turn.show(Screen::kThrow);
    turn.put_on_clay(std::nullopt);
    turn.take(event);
}

std::string_view spoken_to_choose(const State& /*state*/) {
    return "choose.title";
}

void press_card(Turn& turn, const event::Pressed& event) {
    if (event.button == Button::kCardClose) {
        turn.lay_over(Panel::kNone);
    } else if (event.button == Button::kCardThrow && turn.state.card != kRelativesCard) {
        const int place = turn.state.card;
        turn.lay_over(Panel::kNone);
        press_choose(turn, event::Pressed{Button::kTarget, place});
    }
}

}  // namespace

extern constinit const Step kChooseStep{.screen = Screen::kChoose,
                                        .name = "choose",
                                        .enter = enter_choose,
                                        .press = press_choose,
                                        .take = take_choose,
                                        .draw = draw_choose,
                                        .spoken = spoken_to_choose,
                                        .finger = Finger::kLooks,
                                        .turns_wheel = true};

extern constinit const Overlay kCardOverlay{.panel = Panel::kCard,
                                            .name = "card",
                                            .spoken = "card.about",
                                            .press = press_card,
                                            .draw = draw_card_panel};

}  // namespace onggi::visit

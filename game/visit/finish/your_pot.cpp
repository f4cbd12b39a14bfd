// The finished pot with its measures, beside the museum's pot that was its target or that it resembles most.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "game/visit/finish/finish.h"
#include "game/visit/flow/turn.h"

namespace onggi::visit {
namespace {

using ui::Rect;

void measures_card(Page& page, const Rect& card) {
    const FiredPot& pot = *page.view().pot;
    struct Row {
        const char* key;
        std::string number;
        const char* unit;
    };
    const std::array rows{Row{"your.h", fmt::format("{:.0f}", pot.height_mm), "unit.mm"},
                          Row{"your.w", fmt::format("{:.0f}", pot.width_mm), "unit.mm"},
                          Row{"your.wt", fmt::format("{:.0f}", pot.weight_g), "unit.g"},
                          Row{"your.cap", fmt::format("{:.1f}", pot.capacity_l), "unit.l"}};
    page.card(card, design::kHanji, design::kHanji);
    const float step = (card.height - 34.0F) / static_cast<float>(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const float y = card.y + 17.0F + step * static_cast<float>(i);
        const float split = 0.44F * card.width;
        const Rect name{card.x + 28.0F, y, split, step};
        const Rect value{card.x + 28.0F + split, y, card.width - 56.0F - split, step};
        const auto within = [&](const Rect& rect) {
            return page.right_to_left()
                       ? Rect{2.0F * card.x + card.width - rect.right(), rect.y, rect.width, rect.height}
                       : rect;
        };
        const Rect name_box = within(name);
        const float name_line = 40.0F;
        page.words({name_box.x, name_box.y + 0.5F * (step - name_line), name_box.width, name_line + 4.0F},
                   {.text = page.t(rows[i].key), .type = {30.0F, name_line}, .colour = design::kInk2}, true);
        const Rect value_box = within(value);
        // A large number and a small unit in one row, aligned with the end of the line.
        const Words unit{.text = page.t(rows[i].unit),
                         .type = {28.0F, 56.0F},
                         .colour = design::kInk,
                         .align = ui::Align::kEnd};
        const float unit_width = page.words_width(unit) + 2.0F;
        const bool rtl = page.right_to_left();
        const float middle = value_box.y + 0.5F * (step - 56.0F);
        page.fixed_words(
            {rtl ? value_box.x : value_box.right() - unit_width, middle + 4.0F, unit_width, 58.0F}, unit);
        const Rect number_box{rtl ? value_box.x + unit_width + 10.0F : value_box.x, middle,
                              value_box.width - unit_width - 10.0F, 58.0F};
        page.fixed_words(number_box, {.text = page.digits(rows[i].number),
                                      .type = design::bold(46.0F, 56.0F),
                                      .colour = design::kInk,
                                      .align = ui::Align::kEnd});
        if (i + 1 < rows.size()) {
            const Rect rule{card.x + 28.0F, y + step - 1.0F, card.width - 56.0F, 2.0F};
            page.box(rule, {design::kRule, design::kRule, design::kRule, design::kRule});
        }
    }
}

void height_bracket(Page& page, float x, float foot_y, float height) {
    ui::Sketch sketch;
    sketch.add(ui::Shape{.path = fmt::format("M10 2 V{0:.1f} M1.5 2 H18.5 M1.5 {0:.1f} H18.5", height),
                         .stroke = design::kTokenEdge,
                         .stroke_width = 2.5F});
    page.sprite({x - 10.0F, foot_y - height - 2.0F, 20.0F, height + 6.0F}, std::move(sketch));
}

// A circle with a smaller deviation counts as round.
constexpr double kRoundMm = 1.0;

// Draws a true circle over a jar of two bowls, for comparison.
void true_circle(Page& page, vec2 centre, float radius) {
    constexpr int kCorners = 72;
    std::vector<vec2> points;
    for (int i = 0; i <= kCorners; ++i) {
        const float angle = kTurnF * static_cast<float>(i) / kCorners;
        points.push_back(centre + radius * vec2(std::cos(angle), std::sin(angle)));
    }
    page.dotted(points);
}

std::string roundness_words(const Page& page, double off_round_mm) {
    if (off_round_mm < kRoundMm) return page.t("moon.done.one");
    return page.t("moon.done.off", page.digits(fmt::format("{:.0f}", off_round_mm))) + "\n" +
           page.t("moon.done.line");
}

// Where the visitor's pot and the museum's stand, on a left-to-right screen. u, and u per mm.
struct Stands {
    float own_x = 0.0F;
    float own_scale = 0.0F;
    float other_x = 0.0F;
    float other_scale = 0.0F;
};

// The visitor's pot is as large as the stage allows, and the museum's has the rest. At one scale a small pot
// would be a speck beside a large vat, so they have one scale only where the museum's is the smaller picture.
Stands stands_of(const FiredPot& pot, float stage_width, float foot_y) {
    constexpr float kLeft = 62.0F;  // of the bracket
    constexpr float kBetween = 14.0F;
    constexpr float kTitleBottom = 84.0F;
    constexpr float kLeastOther = 128.0F;
    constexpr float kOfHeight = 0.62F;
    constexpr float kOfOwn = 0.75F;
    constexpr float kAnyWidth = 1.0e6F;
    const Exhibit* const relative = pot.relative.get();
    const float room = stage_width - 100.0F;
    const float high = foot_y - kTitleBottom;
    const float wide = 2.0F * pot.shape.radius_mm() * fitting_scale(pot.shape, kAnyWidth, high) + 16.0F;
    const float own_box = relative == nullptr ? room : std::clamp(wide, 0.45F * room, room - kLeastOther);
    Stands stands{.own_x = kLeft + 0.5F * own_box, .own_scale = fitting_scale(pot.shape, own_box, high)};
    if (relative == nullptr) return stands;
    const float own_size = stands.own_scale * std::max(pot.shape.height_mm(), 2.0F * pot.shape.radius_mm());
    const float other_box = room - own_box;
    const float fitting =
        fitting_scale(relative->shape, other_box, std::min(kOfHeight * high, kOfOwn * own_size));
    stands.other_scale = std::min(fitting, stands.own_scale);
    stands.other_x = kLeft + own_box + kBetween + 0.5F * other_box;
    return stands;
}

// How tall the museum's pot really is, where the two are not drawn at one scale.
std::string scale_words(const Page& page, const FiredPot& pot, const Stands& stands) {
    if (stands.other_scale == stands.own_scale) return page.t("your.scale");
    const double ratio = pot.relative->height_mm / std::max(1.0, pot.height_mm);
    return page.t("your.size", page.digits(fmt::format("{:.1f}", ratio)));
}

// The score against the museum's pot that the visitor chose, or the date of the one that resembles the pot.
std::string second_line(const Page& page, const FiredPot& pot) {
    return pot.off_outline_mm ? page.t("your.off", page.whole_mm(*pot.off_outline_mm))
                              : page.t(pot.relative->date_key);
}

// Writes the name of the related museum pot and, below it, one strength of the visitor's pot and what to try
// next. With low controls, the token for the museum pot's card is beside the languages' token.
void near_words(Page& page, const Rect& rect, const FiredPot& pot, const Stands& stands,
                const Rect& languages) {
    constexpr float kSide = 64.0F;
    constexpr float kGap = 14.0F;
    const Exhibit& exhibit = *pot.relative;
    const bool is_jar = pot.off_round_mm.has_value();
    const float about = exhibit.card && !page.is_low() ? kSide + kGap : 0.0F;
    const std::string text = page.t(pot.is_after_relative ? "your.after" : "your.near") +
                             std::string(page.language().punctuation().after_label) +
                             page.t(exhibit.name_key) + (is_jar ? "" : "\n" + second_line(page, pot)) +
                             (is_jar && page.is_low() ? "" : "\n" + scale_words(page, pot, stands));
    const bool rtl = page.right_to_left();
    // The first text has room for three lines of five. A jar's has two lines, or one with low controls, and
    // leaves the rest to the text on roundness.
    const float most = is_jar && page.is_low() ? 40.0F : is_jar ? 78.0F : 114.0F;
    const float fraction = is_jar && page.is_low() ? 0.21F : is_jar ? 0.35F : 0.61F;
    const float split = std::min(fraction * rect.height, most * page.text_scale());
    page.words({rtl ? rect.x + about : rect.x, rect.y, rect.width - about, split - 4.0F},
               {.text = text, .type = design::kReading, .colour = design::kSlip3});
    if (exhibit.card) {
        const Rect beside{rtl ? rect.x : rect.right() - kSide, rect.y + (is_jar ? 2.0F : 23.0F), kSide,
                          kSide};
        const Rect low{rtl ? languages.right() + kGap : languages.x - kGap - kSide, languages.y - 2.0F, kSide,
                       kSide};
        page.token(page.is_low() ? low : beside, Look::kOutline, Button::kCard, page.named("card.about"),
                   kRelativesCard, Icon::kAbout, false);
    }
    page.words({rect.x, rect.y + split, rect.width, rect.height - split},
               {.text = is_jar ? roundness_words(page, *pot.off_round_mm)
                               : page.t(pot.good_key) + "\n" + page.t(pot.next_key),
                .type = design::kReading,
                .colour = design::kSlip});
}

// Stands both pots on the shelf, with their names below it.
void stand_pots(Page& page, const Stands& stands, float stage_width, float foot_y) {
    const FiredPot& pot = *page.view().pot;
    page.keep_clear(page.turning_pot(pot.shape, finish::glaze_at(page.view().state.glaze), stands.own_scale,
                                     {page.mirrored(stands.own_x), foot_y}));
    const float height = pot.shape.height_mm() * stands.own_scale;
    if (const double off_round_mm = pot.off_round_mm.value_or(0.0); off_round_mm >= kRoundMm) {
        const float radius_mm = pot.shape.radius_mm() - 0.5F * static_cast<float>(off_round_mm);
        true_circle(page, {page.mirrored(stands.own_x), foot_y - 0.5F * height},
                    radius_mm * stands.own_scale);
    }
    height_bracket(page, page.mirrored(42.0F), foot_y - 1.0F, height);
    constexpr float kNameWidth = 160.0F;
    const float names_y = foot_y + 26.0F;
    page.words(page.mirrored({stands.own_x - 0.5F * kNameWidth, names_y, kNameWidth, 74.0F}),
               {.text = page.t("your.title") + "\n" + page.whole_mm(pot.height_mm),
                .type = {27.0F, 34.0F},
                .align = ui::Align::kCentre});
    const Exhibit* const relative = pot.relative.get();
    if (relative == nullptr) return;
    constexpr float kDimmer = 0.86F;
    page.keep_clear(page.pot(relative->shape, finish::glaze_at(relative->glaze), stands.other_scale,
                             {page.mirrored(stands.other_x), foot_y}, kDimmer));
    const float name_x = stands.own_x + 0.5F * kNameWidth + 12.0F;
    page.words(
        page.mirrored({name_x, names_y, stage_width - 16.0F - name_x, page.is_square() ? 170.0F : 106.0F}),
        {.text = page.t(relative->name_key) + " \u00b7 " + page.whole_mm(relative->height_mm) + "\n" +
                 page.t(relative->museum_key),
         .type = design::kNote,
         .align = ui::Align::kCentre});
}

void draw_your_pot(Page& page) {
    const View& view = page.view();
    const float width = page.width();
    const float height = page.height();
    const bool tall = page.is_tall();
    const bool square = page.is_square();
    const float raised = page.is_low() ? 78.0F : 0.0F;  // room for the languages' token
    const float shelf_y = tall ? 590.0F - raised : 546.0F;
    const float foot_y = shelf_y + 14.0F;
    const float stage_width = page.by_shape(760.0F, 560.0F, width);
    const Stands stands = view.pot ? stands_of(*view.pot, stage_width, foot_y) : Stands{};
    // The light is on the visitor's pot.
    page.museum({page.mirrored(stands.own_x), shelf_y - 230.0F},
                tall ? vec2(0.62F * width, 0.3F * height) : vec2(0.38F * width, 0.62F * height), 0.42F);
    page.shelf(shelf_y, 34.0F);
    page.down({0.0F, shelf_y + 34.0F, width, height - shelf_y - 34.0F}, ui::hex(0x150e09), ui::hex(0x231912));
    const bool is_off_round = view.pot && view.pot->off_round_mm.value_or(0.0) >= kRoundMm;
    page.words(page.mirrored({32.0F, 24.0F, width - 260.0F, 66.0F}),
               {.text = page.t(is_off_round ? "moon.done.title" : "your.title"), .type = design::kTitle});
    const Rect languages = page.languages_token(
        {width - 182.0F, tall ? height - 182.0F : page.lower_by() + (square ? 480.0F : 474.0F), 150.0F,
         60.0F});
    if (!view.pot) return;

    stand_pots(page, stands, stage_width, foot_y);
    const bool is_related = view.pot->relative != nullptr;
    const float card_x = tall ? 40.0F : stage_width + 10.0F;
    const float card_width = tall ? width - 80.0F : width - 32.0F - card_x;
    const float card_height = !is_related ? 320.0F : square && !page.is_low() ? 272.0F : 222.0F;
    const Rect card = page.mirrored({card_x, (tall ? 740.0F : 118.0F) - raised, card_width, card_height});
    measures_card(page, card);
    const float y = tall ? height - 110.0F : height - 108.0F;
    if (is_related) {
        const float top = card.bottom() + 12.0F;
        const float bottom = page.is_low() ? languages.y : y;
        near_words(page, page.mirrored({card_x + 6.0F, top, card_width - 6.0F, bottom - 4.0F - top}),
                   *view.pot, stands, languages);
    }
    const float left_width = 0.46F * card_width;
    page.token(page.mirrored({card_x, y, left_width, 76.0F}), Look::kOutline, Button::kOtherGlaze,
               page.named("your.glaze"));
    page.token(page.mirrored({card_x + left_width + 18.0F, y, card_width - left_width - 18.0F, 76.0F}),
               Look::kPrimary, Button::kKeep, page.named("your.keep"));
}

void press_your_pot(Turn& turn, const event::Pressed& event) {
    if (event.button == Button::kOtherGlaze) {
        turn.show(Screen::kGlaze);
    } else if (event.button == Button::kCard) {
        turn.state.card = kRelativesCard;
        turn.lay_over(Panel::kCard);
    } else if (event.button == Button::kKeep) {
        turn.show(Screen::kKeep);
    }
}

std::string_view spoken_of_pot(const State& /*state*/) {
    return "your.title";
}

}  // namespace

extern constinit const Step kYourPotStep{.screen = Screen::kYourPot,
                                         .name = "your-pot",
                                         .press = press_your_pot,
                                         .draw = draw_your_pot,
                                         .spoken = spoken_of_pot};

}  // namespace onggi::visit

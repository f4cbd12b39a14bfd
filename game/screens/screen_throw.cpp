// Throwing: the clay and nothing over it; what can be done stands on the ledge. The three moves are shown by
// ghost hands, the danger by a sign on the pot, a card and a section of the wall.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "game/screens/screens.h"

namespace onggi::screens {
namespace {

using kiosk::Button;
using ui::Rect;

float ledge_y(const Page& page) {
    return screens::ledge_y(page.shape(), page.height(), page.view().state.comfort);
}

// What larger text has made the ledge higher by, for the caption's row and for the labels below the tokens.
struct Growth {
    float caption = 0.0F;
    float labels = 0.0F;
};
Growth growth(const Page& page) {
    const float all = ledge_growth(page.view().state.comfort);
    if (page.shape() == Shape::kWide) return {all, all};
    return {0.45F * all, 0.55F * all};
}

// The button way for every drag, for who asks for controls within reach, and for who has one switch.
bool has_hand_pad(const View& view) {
    return view.state.comfort.reach || view.scans;
}

// Where pot, tool and hands are to be seen: no words there but on cards.
Rect pot_box(const Page& page) {
    if (page.view().state.comfort.reach)
        return {0.38F * page.width(), 0.42F * page.height(), 0.2F * page.width(),
                ledge_y(page) - 0.42F * page.height()};
    const bool padded = has_hand_pad(page.view());  // it stands beside the pot, over the wheel's edge
    switch (page.shape()) {
        case Shape::kTall:
            return {90.0F, 240.0F, padded ? 330.0F : 550.0F, ledge_y(page) - 260.0F};
        case Shape::kSquare:
            return {260.0F, 114.0F, padded ? 450.0F : 510.0F, ledge_y(page) - 124.0F};
        case Shape::kWide:
            break;
    }
    return {340.0F, 56.0F, 600.0F, ledge_y(page) - 70.0F};
}

constexpr std::array kStepIcons{Icon::kStepPress, Icon::kStepOpen, Icon::kStepRaise};
constexpr std::array kStepKeys{"step.press", "step.open", "step.raise"};

// Three sections of the clay: what is done, what is next, what comes.
void steps(Page& page, float x, float y, int done) {
    for (int i = 0; i < kiosk::kTeachingSteps; ++i) {
        const bool current = i == done;
        const float side = current ? 64.0F : 50.0F;
        const float left = x + static_cast<float>(i) * 74.0F;
        const Rect field = page.on_ledge({left, y, 64.0F, 72.0F});
        ui::Sketch sketch;
        const vec2 at(32.0F - 0.5F * side, current ? 0.0F : 9.0F);
        const Icon icon = kStepIcons[static_cast<std::size_t>(i)];
        if (current) {
            add_icon(sketch, icon, at, side, ui::hex(0xfff3d9));
            sketch.add(ui::Box{{4.0F, 66.0F, 56.0F, 5.0F}, 3.0F, ui::Fill::flat(design::kAmber)});
        } else {
            const auto fill = i < done ? std::optional<ui::Colour>(ui::hex(0x8b6a48)) : std::nullopt;
            add_icon(sketch, icon, at, side, ui::hex(0xd6c6ac, 0.75F), fill);
        }
        page.sprite(field, std::move(sketch));
        if (i < done) {
            ui::Sketch tick;
            add_icon(tick, Icon::kCheck, {0.0F, 0.0F}, 22.0F, design::kAmber);
            page.sprite(page.on_ledge({left + 44.0F, y - 8.0F, 22.0F, 22.0F}), std::move(tick));
        }
    }
}

void teaching(Page& page) {
    const kiosk::Throwing& throwing = page.view().state.throwing;
    const float y = ledge_y(page);
    const int done = throwing.steps_done;
    const std::string& text =
        page.t(done < kiosk::kTeachingSteps ? kStepKeys[static_cast<std::size_t>(done)] : "step.own");
    const auto align = page.view().state.comfort.left_hand ? ui::Align::kEnd : ui::Align::kStart;
    if (page.shape() == Shape::kWide) {
        steps(page, 32.0F, y + 16.0F, done);
        page.words(page.on_ledge({34.0F, y + 94.0F, 296.0F, 36.0F + growth(page).caption}),
                   {.text = text, .size = 27.0F, .line = 34.0F, .bold = true, .align = align});
        return;
    }
    const bool tall = page.shape() == Shape::kTall;
    steps(page, 32.0F, y + (tall ? 24.0F : 16.0F), done);
    page.words(page.on_ledge({282.0F, y + (tall ? 30.0F : 28.0F), page.width() - 314.0F,
                              (tall ? 84.0F : 44.0F) + growth(page).caption}),
               {.text = text, .size = tall ? 32.0F : 30.0F, .line = 42.0F, .bold = true, .align = align});
}

// The wall's section with its thinnest place.
void gauge(Page& page, const Rect& rect) {
    ui::Sketch sketch;
    const ui::Placing placing{.at = {-64.0F, 0.0F}};
    sketch.add(
        ui::Shape{.path = "M66 13 C90 15 110 18 150 24 C190 28 205 31 226 31 C250 31 270 26 296 22 L296 46 "
                          "C270 42 250 39 226 39 C205 39 190 42 150 46 C110 52 90 55 66 57 Z",
                  .placing = placing,
                  .fill = ui::hex(0xc79a6c),
                  .stroke = ui::hex(0xfff3d9),
                  .stroke_width = 3.0F});
    sketch.add(ui::Shape{.path = "M226 4 V24 M219 17 L226 25 L233 17 M226 66 V46 M219 53 L226 45 L233 53",
                         .placing = placing,
                         .stroke = ui::hex(0xffb98a),
                         .stroke_width = 4.0F});
    page.sprite({rect.x, rect.y, 236.0F, 70.0F}, std::move(sketch));
    page.words({rect.x, rect.y + 70.0F, 236.0F, 36.0F},
               {.text = page.measure(fmt::format("{:.1f}", page.view().thinnest_mm), "unit.mm"),
                .size = 27.0F,
                .line = 34.0F,
                .bold = true,
                .colour = ui::hex(0xffd9b8),
                .align = ui::Align::kCentre});
}

void controls(Page& page) {
    const kiosk::Throwing& throwing = page.view().state.throwing;
    const bool reversed = page.right_to_left();
    const float label_height = 36.0F + growth(page).labels * (page.shape() == Shape::kTall ? 0.5F : 1.0F);
    constexpr float kBelow = 8.0F;  // the ring goes round a control and not through its label
    const auto stepper = [&](const Rect& place, Icon icon, int dots, int on, Button less, Button more,
                             const char* key) {
        const Rect rect = page.on_ledge(place);
        page.stepper(rect, icon, dots, on, less, more, page.t(key), reversed);
        page.label({rect.x - 6.0F, rect.bottom() + kBelow, rect.width + 12.0F, label_height}, page.t(key));
    };
    const auto round = [&](const Rect& place, Icon icon, Button button, const char* key, float label_width) {
        const Rect rect = page.on_ledge(place);
        page.token(rect, Look::kToken, button, page.t(key), 0, icon, false);
        constexpr float kEdge = 14.0F;
        const float x =
            std::clamp(rect.centre().x - 0.5F * label_width, kEdge, page.width() - kEdge - label_width);
        page.label({x, rect.bottom() + kBelow, label_width, label_height}, page.t(key));
    };
    const float width = page.width();
    if (page.shape() == Shape::kTall) {
        const float y = ledge_y(page) + 116.0F + growth(page).caption;
        const float second_row = 132.0F + 0.5F * growth(page).labels;
        stepper({32.0F, y, 164.0F, 66.0F}, Icon::kTool, kiosk::kMostTool, throwing.tool, Button::kToolLess,
                Button::kToolMore, "ctl.tool");
        stepper({278.0F, y, 164.0F, 66.0F}, Icon::kWater, kiosk::kMostWater, throwing.water,
                Button::kWaterLess, Button::kWaterMore, "ctl.water");
        stepper({width - 196.0F, y, 164.0F, 66.0F}, Icon::kSpeed, kiosk::kMostSpeed, throwing.speed,
                Button::kSpeedLess, Button::kSpeedMore, "ctl.speed");
        round({32.0F, y + second_row, 84.0F, 66.0F}, Icon::kAgain, Button::kNewClay, "ctl.again", 136.0F);
        round({184.0F, y + second_row, 84.0F, 66.0F}, Icon::kUndo, Button::kUndo, "ctl.undo", 136.0F);
        page.token(page.on_ledge({width - 312.0F, y + second_row, 280.0F, 80.0F}), Look::kPrimary,
                   Button::kDone, page.t("ctl.done"), 0, Icon::kDone);
        return;
    }
    const bool square = page.shape() == Shape::kSquare;
    const float y = ledge_y(page) + (square ? 92.0F + growth(page).caption : 22.0F);
    const float gap = square ? 8.0F : 12.0F;
    const float done_width = square ? 132.0F : 156.0F;
    float x = width - (square ? 20.0F : 32.0F) - done_width;
    page.token(page.on_ledge({x, y, done_width, 66.0F}), Look::kPrimary, Button::kDone, page.t("ctl.done"));
    x -= 164.0F + gap + 4.0F;
    stepper({x, y, 164.0F, 66.0F}, Icon::kSpeed, kiosk::kMostSpeed, throwing.speed, Button::kSpeedLess,
            Button::kSpeedMore, "ctl.speed");
    x -= 164.0F + gap;
    stepper({x, y, 164.0F, 66.0F}, Icon::kWater, kiosk::kMostWater, throwing.water, Button::kWaterLess,
            Button::kWaterMore, "ctl.water");
    x -= 164.0F + gap;
    stepper({x, y, 164.0F, 66.0F}, Icon::kTool, kiosk::kMostTool, throwing.tool, Button::kToolLess,
            Button::kToolMore, "ctl.tool");
    const float between = square ? 30.0F : 34.0F;
    x -= 70.0F + between - 8.0F;
    round({x, y, 70.0F, 66.0F}, Icon::kUndo, Button::kUndo, "ctl.undo", 96.0F);
    x -= 106.0F;  // so that the two labels stay apart
    round({x, y, 70.0F, 66.0F}, Icon::kAgain, Button::kNewClay, "ctl.again", 112.0F);
}

// Dots along the target's outline, cream over dark. Drawn in the scene's pixels, never mirrored.
void outline(Page& page) {
    const View& view = page.view();
    const float u = 1.0F / page.px_per_u();
    for (const std::vector<vec2>& line : view.outline_px) {
        if (line.size() < 2) continue;
        vec2 low = line.front() * u;
        vec2 high = low;
        for (const vec2& point : line) {
            low = glm::min(low, point * u);
            high = glm::max(high, point * u);
        }
        constexpr float kAir = 6.0F;
        std::string path;
        for (const vec2& point : line) {
            const vec2 at = point * u - low + kAir;
            path += fmt::format("{}{:.1f} {:.1f} ", path.empty() ? 'M' : 'L', at.x, at.y);
        }
        ui::Sketch sketch;
        sketch.add(ui::Shape{
            .path = path, .stroke = design::kNight.with_alpha(0.55F), .stroke_width = 7.0F, .dash = 13.0F});
        sketch.add(ui::Shape{.path = path, .stroke = design::kOutline, .stroke_width = 4.4F, .dash = 13.0F});
        page.sprite({low.x - kAir, low.y - kAir, high.x - low.x + 2.0F * kAir, high.y - low.y + 2.0F * kAir},
                    std::move(sketch));
    }
}

void ghost(Page& page, HandPose pose, vec2 at, bool flipped, vec2 way) {
    Rect reach = ghost_hand_reach(pose);
    if (flipped) reach.x = -reach.x - reach.width;
    ui::Sketch sketch;
    add_ghost_hand(sketch, pose, {-reach.x, -reach.y}, 1.0F, flipped);
    page.sprite(reach.moved(at), std::move(sketch), -1, Role::kHint, way);
}

// Where a hand goes next: dots, and a head at their end.
void way_of_hand(Page& page, vec2 from, vec2 to) {
    const vec2 along = glm::normalize(to - from);
    const vec2 across(-along.y, along.x);
    const vec2 low = glm::min(from, to) - 22.0F;
    const vec2 high = glm::max(from, to) + 22.0F;
    const auto word = [&](vec2 at) { return fmt::format("{:.1f} {:.1f}", at.x - low.x, at.y - low.y); };
    const std::string dots = fmt::format("M{} L{}", word(from), word(to));
    const std::string head = fmt::format("M{} L{} L{}", word(to - 6.0F * along + 12.0F * across),
                                         word(to + 8.0F * along), word(to - 6.0F * along - 12.0F * across));
    ui::Sketch sketch;
    add_path(sketch, dots, head);
    page.sprite({low.x, low.y, high.x - low.x, high.y - low.y}, std::move(sketch), -1, Role::kHint);
}

void hint(Page& page) {
    const View& view = page.view();
    const int step = view.state.throwing.steps_done;
    if (step >= kiosk::kTeachingSteps) return;
    const bool left = view.state.comfort.left_hand;
    const float side = left ? -1.0F : 1.0F;
    const vec2 at = view.hint_at_px / page.px_per_u();
    const vec2 inside = view.second_hint_at_px / page.px_per_u();
    // The hands' fingertips are at their origin's left; the way is what the hand does in a loop.
    if (step == 0) {
        ghost(page, HandPose::kPress, at + vec2(side * 26.0F, -40.0F), left, {-side * 20.0F, 0.0F});
        way_of_hand(page, at + vec2(side * 130.0F, -72.0F), at + vec2(side * 50.0F, -72.0F));
    } else if (step == 1) {
        ghost(page, HandPose::kInside, inside + vec2(-36.0F * side, -110.0F), left, {0.0F, 34.0F});
        way_of_hand(page, inside + vec2(side * 124.0F, -90.0F), inside + vec2(side * 124.0F, -26.0F));
    } else {
        ghost(page, HandPose::kPress, at + vec2(side * 6.0F, -40.0F), left, {0.0F, -46.0F});
        ghost(page, HandPose::kInside, inside + vec2(-60.0F * side, -84.0F), left, {0.0F, -46.0F});
        way_of_hand(page, at + vec2(side * 130.0F, -20.0F), at + vec2(side * 130.0F, -100.0F));
    }
}

void warning_card(Page& page) {
    const View& view = page.view();
    const bool tall = page.shape() == Shape::kTall;
    const bool square = page.shape() == Shape::kSquare;
    const bool low = has_hand_pad(view) && page.shape() == Shape::kWide;
    const float width = page.width();
    // Brought low, it stands across from the hand's keys.
    const Rect card =
        tall  ? Rect{60.0F, 104.0F, 600.0F, 128.0F}
        : low ? page.mirrored({32.0F, 290.0F, 376.0F, 156.0F})
              : page.mirrored({width - (square ? 360.0F : 408.0F), 112.0F, square ? 336.0F : 376.0F, 156.0F});
    if (view.warning_at_px) {
        const vec2 from =
            tall ? vec2(0.5F * width, card.bottom())
                 : vec2(page.right_to_left() != low ? card.right() : card.x, card.bottom() - 28.0F);
        const vec2 to = *view.warning_at_px / page.px_per_u();
        const vec2 corner = glm::min(from, to) - 6.0F;
        const vec2 size = glm::abs(to - from) + 12.0F;
        const std::string path = fmt::format("M{:.1f} {:.1f} L{:.1f} {:.1f}", from.x - corner.x,
                                             from.y - corner.y, to.x - corner.x, to.y - corner.y);
        ui::Sketch sketch;
        sketch.add(ui::Shape{.path = path, .stroke = design::kNight.with_alpha(0.6F), .stroke_width = 7.0F});
        sketch.add(ui::Shape{.path = path, .stroke = ui::hex(0xfff1d6), .stroke_width = 3.5F});
        page.sprite({corner.x, corner.y, size.x, size.y}, std::move(sketch));
    }
    const char* const key = view.state.throwing.warning == kiosk::Warning::kThin  ? "warn.thin"
                            : view.state.throwing.warning == kiosk::Warning::kWet ? "warn.wet"
                                                                                  : "warn.fast";
    page.card(card, design::kHanji, design::kHanji);
    Words head{.text = page.t(key), .size = 30.0F, .line = 40.0F, .bold = true, .colour = design::kRust};
    Words advice{
        .text = page.t(std::string(key) + "2"), .size = 28.0F, .line = 38.0F, .colour = design::kInk};
    // Both as large as the card bears, not the first at the cost of the second.
    const Rect inner{card.x + 20.0F, card.y + 14.0F, card.width - 40.0F, card.height - 22.0F};
    float scale = page.text_scale();
    float head_height = 0.0F;
    for (;; scale = std::max(1.0F, page.smaller(scale, 1.0F))) {
        const ui::TextSize one = page.words_size(head, scale, inner.width);
        const ui::TextSize other = page.words_size(advice, scale, inner.width);
        head_height = one.height + 4.0F;
        if (scale <= 1.0F) break;
        if (head_height + other.height <= inner.height && !one.too_wide && !other.too_wide) break;
    }
    for (Words* words : {&head, &advice}) {
        words->size *= scale;
        words->line *= scale;
    }
    page.fixed_words({inner.x, inner.y, inner.width, inner.height - 40.0F}, head);
    page.fixed_words({inner.x, inner.y + head_height, inner.width, inner.height - head_height}, advice);
}

void hand_pad(Page& page) {
    // Right above the ledge and as on a keyboard, because a cross would leave the lower half.
    const float edge = page.shape() == Shape::kTall ? 24.0F : 32.0F;
    const Rect pad = page.mirrored({page.width() - edge - 264.0F, ledge_y(page) - 172.0F, 264.0F, 164.0F});
    const bool out_is_right = !page.view().state.comfort.left_hand;
    page.token({pad.x + 92.0F, pad.y, 80.0F, 76.0F}, Look::kToken, Button::kHandUp, page.t("ctl.up"), 0,
               Icon::kUp, false, true);
    page.token({pad.x, pad.y + 88.0F, 80.0F, 76.0F}, Look::kToken, Button::kHandLeft,
               page.t(out_is_right ? "ctl.in" : "ctl.out"), 0, Icon::kLeft, false, true);
    page.token({pad.x + 184.0F, pad.y + 88.0F, 80.0F, 76.0F}, Look::kToken, Button::kHandRight,
               page.t(out_is_right ? "ctl.out" : "ctl.in"), 0, Icon::kRight, false, true);
    page.token({pad.x + 92.0F, pad.y + 88.0F, 80.0F, 76.0F}, Look::kToken, Button::kHandDown,
               page.t("ctl.down"), 0, Icon::kDown, false, true);
}

// As wide as its words, up to that; where they need more lines than it has room for, it grows down.
void chip(Page& page, const Rect& rect, const std::string& text) {
    const Words words{.text = text, .size = 26.0F, .line = 32.0F, .align = ui::Align::kCentre};
    const float wide = std::min(rect.width, page.words_width(words) * page.text_scale() + 44.0F);
    const float least = page.words_size(words, 1.0F, wide - 36.0F).height + 16.0F;
    const Rect body{rect.centre().x - 0.5F * wide, rect.y, wide, std::max(rect.height, least)};
    ui::Sketch sketch;
    sketch.add(ui::Box{
        {0.0F, 0.0F, body.width, body.height}, 24.0F, ui::Fill::flat(design::kNight.with_alpha(0.86F))});
    page.sprite(body, std::move(sketch));
    page.words({body.x + 18.0F, body.y + 8.0F, body.width - 36.0F, body.height - 14.0F}, words, true);
}

}  // namespace

void add_path(ui::Sketch& sketch, const std::string& dots, const std::string& head) {
    const ui::Colour dark = design::kNight.with_alpha(0.6F);
    const ui::Colour pale = ui::hex(0xfff3d9);
    sketch.add(ui::Shape{.path = dots, .stroke = dark, .stroke_width = 13.0F, .dash = 17.0F});
    sketch.add(ui::Shape{.path = head, .stroke = dark, .stroke_width = 13.0F});
    sketch.add(ui::Shape{.path = dots, .stroke = pale, .stroke_width = 7.5F, .dash = 17.0F});
    sketch.add(ui::Shape{.path = head, .stroke = pale, .stroke_width = 7.5F});
}

void draw_throw(Page& page) {
    const View& view = page.view();
    const float y = ledge_y(page);
    page.keep_clear(pot_box(page));
    page.scene_ends();
    outline(page);
    if (view.hint) hint(page);
    const bool warned = view.state.throwing.warning != kiosk::Warning::kNone;
    page.ledge(y);
    if (warned) warning_card(page);
    const bool shows_gauge = view.state.throwing.warning == kiosk::Warning::kThin && view.thinnest_mm > 0.0;
    if (shows_gauge && page.shape() == Shape::kWide) {
        gauge(page, page.on_ledge({36.0F, y + 20.0F, 236.0F, 104.0F}));
    } else {
        teaching(page);
    }
    if (has_hand_pad(view)) hand_pad(page);  // the ring comes to it before it comes to what ends the throwing
    controls(page);
    // Brought low, they stand over the hand's keys, or across from them.
    const Rect languages =
        page.languages_token(page.shape() == Shape::kTall ? Rect{page.width() - 182.0F, 648.0F, 150.0F, 60.0F}
                                                          : Rect{32.0F, 478.0F, 150.0F, 60.0F});
    add_forces(page);
    if (view.can_look_in) page.look_in_token(languages);
    const float middle = 0.5F * page.width();
    if (view.state.device_lost || view.state.force_rests) {
        const bool tall = page.shape() == Shape::kTall;
        const float wide = tall ? page.width() - 64.0F : std::min(660.0F, page.width() - 400.0F);
        chip(page, {middle - 0.5F * wide, tall ? 104.0F : 28.0F, wide, 84.0F},
             page.t(view.state.device_lost ? "dev.lost" : "dev.rest"));
    } else if (!view.heard.empty()) {
        // Where hand pad and caption have no room beside each other, the caption stands across from the pad.
        const bool beside = page.shape() == Shape::kTall && has_hand_pad(view);
        chip(page,
             beside ? page.mirrored({24.0F, y - 58.0F, 390.0F, 48.0F})
                    : Rect{middle - 200.0F, y - 58.0F, 400.0F, 48.0F},
             page.t(view.heard));
    }
    if (view.state.throwing.target && !view.outline_px.empty() && view.hint && !warned) {
        const float width = page.shape() == Shape::kWide ? 300.0F : 420.0F;
        chip(page, page.mirrored({24.0F, 28.0F, width, 84.0F}), page.t("out.target"));
    }
}

}  // namespace onggi::screens

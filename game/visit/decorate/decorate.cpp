// Decorating, after drying and before firing. It is optional.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "game/screens/page/ledge_parts.h"
#include "game/visit/flow/turn.h"

namespace onggi::visit {
namespace {

using ui::Rect;

void enter_decorate(Turn& turn) {
    turn.state.decorating = {.turns = !turn.state.comfort.still};
    turn.add(effect::BeginDrawing{});
}

void lift_brush(Turn& turn) {
    if (!turn.state.decorating.brush_down) return;
    turn.state.decorating.brush_down = false;
    turn.add(effect::PutBrush{.down = false});
}

void take_tool(Turn& turn, int tool) {
    if (tool < 0 || tool >= kDrawingTools) return;
    turn.state.decorating.tool = tool;
    turn.state.decorating.touched = false;
}

// A motif is placed at once; a brush stays down until it is lifted.
void put_brush(Turn& turn) {
    Decorating& decorating = turn.state.decorating;
    if (decorating.brush_down) return lift_brush(turn);
    decorating.brush_down = decorating.tool != kMotifTool;
    turn.add(effect::PutBrush{.down = true});
}

void press_decorate(Turn& turn, const event::Pressed& event) {
    Decorating& decorating = turn.state.decorating;
    if (!moves_hand(event.button) && event.button != Button::kPutBrush) lift_brush(turn);
    switch (event.button) {
        case Button::kDrawingTool:
            take_tool(turn, event.value);
            break;
        case Button::kMotif:
            if (event.value >= 0 && event.value < kMotifs) decorating.motif = event.value;
            break;
        case Button::kBack:
            take_tool(turn, 0);
            break;
        case Button::kAllRound:
            decorating.all_round = !decorating.all_round;
            break;
        case Button::kSlip:
            decorating.black = event.value == 1;
            break;
        case Button::kToolLess:
        case Button::kToolMore:
            decorating.brush =
                std::clamp(decorating.brush + (event.button == Button::kToolMore ? 1 : -1), 1, kMostBrush);
            break;
        case Button::kTurning:
            decorating.turns = !decorating.turns;
            break;
        case Button::kUndo:
            turn.add(effect::UndoStroke{});
            break;
        case Button::kClear:
            if (decorating.strokes > 0) turn.add(effect::ClearDrawing{});
            break;
        case Button::kPutBrush:
            put_brush(turn);
            break;
        case Button::kDone:
            turn.add(effect::EndDrawing{});
            turn.state.firing = FiringStage::kFire;
            turn.show(Screen::kFiring);
            break;
        default:
            if (moves_hand(event.button)) turn.add(effect::MoveHand{event.button});
            break;
    }
}

void take_decorate(Turn& turn, const Event& event) {
    const auto* const drawn = std::get_if<event::Drawn>(&event);
    if (drawn == nullptr) return;
    Decorating& decorating = turn.state.decorating;
    decorating.touched = decorating.touched || drawn->strokes > decorating.strokes;
    decorating.strokes = std::max(0, drawn->strokes);
}

struct DrawingChoice {
    Icon icon;
    const char* key;
};
// The card of a technique: a name and a sentence.
struct WayWords {
    const char* title;
    const char* line;
};
constexpr std::array<WayWords, kDrawingTools> kWayWords{{{"dec.finger.t", "dec.finger.h"},
                                                         {"dec.iron.t", "dec.iron.h"},
                                                         {"dec.cobalt.t", "dec.cobalt.h"},
                                                         {"dec.inlay.t", "dec.inlay.h"},
                                                         {"dec.white.t", "dec.white.h"},
                                                         {nullptr, "dec.motif.how"}}};
constexpr std::array<DrawingChoice, kDrawingTools> kToolChoices{{{Icon::kFingerWaves, "dec.finger"},
                                                                 {Icon::kIronBrush, "dec.iron"},
                                                                 {Icon::kBlueBrush, "dec.cobalt"},
                                                                 {Icon::kInlay, "dec.inlay"},
                                                                 {Icon::kWhiteBrush, "dec.white"},
                                                                 {Icon::kFlower, "dec.motif"}}};
constexpr std::array<DrawingChoice, kMotifs> kMotifChoices{{{Icon::kCrane, "mo.crane"},
                                                            {Icon::kCloud, "mo.cloud"},
                                                            {Icon::kMum, "mo.mum"},
                                                            {Icon::kFish, "mo.fish"},
                                                            {Icon::kGrass, "mo.grass"},
                                                            {Icon::kWave, "mo.wave"}}};

// The layout of the ledge for each shape of picture.
struct LedgePlaces {
    std::array<Rect, 6> choices;
    std::array<Rect, 2> slips;  // shown in place of the size, like the next two
    Rect around;
    Rect back;
    Rect size;
    Rect turning;
    Rect undo;
    Rect clear;
    Rect done;
    float label = 36.0F;  // height of one label
};

LedgePlaces ledge_places(const Page& page, float top) {
    LedgePlaces places;
    const float grown = ledge_growth(page.view().state.comfort);
    const auto row = [&](float x, float y, float wide, float pitch) {
        for (std::size_t i = 0; i < places.choices.size(); ++i)
            places.choices[i] = {x + pitch * static_cast<float>(i), y, wide, 66.0F};
    };
    switch (page.shape()) {
        case Shape::kTall: {
            places.label = 34.0F + 0.5F * grown;
            const float second = top + 148.0F + 0.5F * grown;
            row(26.0F, top + 30.0F, 98.0F, 114.0F);
            places.size = {32.0F, second, 164.0F, 66.0F};
            places.slips = {Rect{26.0F, second, 78.0F, 66.0F}, Rect{122.0F, second, 78.0F, 66.0F}};
            places.around = {33.0F, second, 84.0F, 66.0F};
            places.back = {142.0F, second, 64.0F, 66.0F};
            places.turning = {252.0F, second, 84.0F, 66.0F};
            places.undo = {412.0F, second, 90.0F, 66.0F};
            places.clear = {568.0F, second, 90.0F, 66.0F};
            places.done = {32.0F, page.height() - 96.0F, page.width() - 64.0F, 80.0F};
            break;
        }
        case Shape::kSquare: {
            places.label = 36.0F + 0.75F * grown;
            const float y = top + 14.0F;
            const float second = page.height() - 78.0F;
            row(20.0F, y, 84.0F, 96.0F);
            places.slips = {Rect{602.0F, y, 72.0F, 66.0F}, Rect{690.0F, y, 72.0F, 66.0F}};
            places.size = {606.0F, y, 164.0F, 66.0F};
            places.around = {611.0F, y, 84.0F, 66.0F};
            places.back = {714.0F, y, 58.0F, 66.0F};
            places.turning = {788.0F, y, 76.0F, 66.0F};
            places.undo = {922.0F, y, 72.0F, 66.0F};
            places.clear = {32.0F, second, 200.0F, 66.0F};
            places.done = {page.width() - 332.0F, second, 300.0F, 66.0F};
            break;
        }
        case Shape::kWide: {
            places.label = 36.0F + grown;
            const float y = top + 22.0F;
            row(32.0F, y, 78.0F, 90.0F);
            places.slips = {Rect{578.0F, y, 74.0F, 66.0F}, Rect{666.0F, y, 74.0F, 66.0F}};
            places.size = {580.0F, y, 164.0F, 66.0F};
            places.around = {589.0F, y, 84.0F, 66.0F};
            places.back = {691.0F, y, 56.0F, 66.0F};
            places.turning = {760.0F, y, 76.0F, 66.0F};
            places.undo = {867.0F, y, 72.0F, 66.0F};
            places.clear = {965.0F, y, 72.0F, 66.0F};
            places.done = {page.width() - 224.0F, y, 192.0F, 66.0F};
            break;
        }
    }
    return places;
}

constexpr float kWideLabel = 17.0F;  // extends past its token on either side
constexpr float kLessWideLabel = 12.0F;

void choice_token(Page& page, const Rect& place, float label, const DrawingChoice& shown, Button button,
                  int value, bool chosen, float spread = 6.0F) {
    add_choice(page, place,
               {.icon = shown.icon, .key = shown.key, .button = button, .value = value, .chosen = chosen},
               label, spread);
}

// Draws the card of the technique until the technique is used.
void way_card(Page& page) {
    const Decorating& decorating = page.view().state.decorating;
    if (decorating.touched) return;
    const WayWords& way = kWayWords[static_cast<std::size_t>(decorating.tool)];
    const bool tall = page.is_tall();
    const bool square = page.is_square();
    const float wide = page.by_shape(304.0F, 244.0F, 430.0F);
    const float most = page.by_shape(264.0F, 290.0F, 186.0F);
    std::vector<Words> lines;
    if (way.title != nullptr)
        lines.push_back({.text = page.t(way.title), .type = design::kHeading, .colour = design::kInk});
    lines.push_back({.text = page.t(way.line), .type = design::kPaper, .colour = design::kInk2});
    add_paper(page, page.mirrored({square ? 20.0F : 32.0F, tall ? 32.0F : 112.0F, wide, most}), lines);
}

// Draws keys for visitors who cannot point at the pot: they move a dot up, down and round, and press the
// brush.
void brush_pad(Page& page, float top) {
    const float edge = page.is_tall() ? 24.0F : 32.0F;
    const Rect pad = page.mirrored({page.width() - edge - 264.0F, top - 172.0F, 264.0F, 164.0F});
    const auto arrow = [&](float x, float y, Button button, const char* key, Icon icon) {
        page.token({pad.x + x, pad.y + y, 80.0F, 76.0F}, Look::kToken, button, page.named(key), 0, icon,
                   false, true);
    };
    arrow(92.0F, 0.0F, Button::kHandUp, "ctl.up", Icon::kUp);
    page.token({pad.x + 184.0F, pad.y, 80.0F, 76.0F}, Look::kToken, Button::kPutBrush, page.named("dec.put"),
               0, Icon::kBrushDown, false);
    arrow(0.0F, 88.0F, Button::kHandLeft, "ctl.left", Icon::kLeft);
    arrow(92.0F, 88.0F, Button::kHandDown, "ctl.down", Icon::kDown);
    arrow(184.0F, 88.0F, Button::kHandRight, "ctl.right", Icon::kRight);
}

Rect decorate_box(const Page& page, float top) {
    const bool padded = page.view().scans || page.is_low();
    return page.by_shape(Rect{350.0F, 56.0F, 580.0F, top - 70.0F}, Rect{280.0F, 114.0F, 430.0F, top - 124.0F},
                         Rect{90.0F, 240.0F, padded ? 330.0F : 550.0F, top - 260.0F});
}

void draw_decorate(Page& page) {
    const View& view = page.view();
    const Decorating& decorating = view.state.decorating;
    const float top = ledge_y(page.shape(), page.height(), view.state.comfort);
    const bool is_motif = decorating.tool == kMotifTool;
    const bool is_square = page.is_square();
    page.keep_clear(decorate_box(page, top));
    page.scene_ends();
    page.ledge(top);
    page.allow_cue();
    way_card(page);
    if (view.scans || page.is_low()) brush_pad(page, top);
    const LedgePlaces places = ledge_places(page, top);
    const float label = places.label;
    for (std::size_t i = 0; i < places.choices.size(); ++i) {
        const int value = static_cast<int>(i);
        if (is_motif) {
            choice_token(page, places.choices[i], label, kMotifChoices[i], Button::kMotif, value,
                         value == decorating.motif);
        } else {
            choice_token(page, places.choices[i], label, kToolChoices[i], Button::kDrawingTool, value,
                         value == decorating.tool);
        }
    }
    if (is_motif) {
        choice_token(page, places.around, label, {Icon::kTurns, "dec.around"}, Button::kAllRound, 0,
                     decorating.all_round, kWideLabel);
        choice_token(page, places.back, label,
                     {page.right_to_left() ? Icon::kRight : Icon::kLeft, "dec.back"}, Button::kBack, 0, false,
                     2.5F);
    } else if (decorating.tool == kInlayTool) {
        choice_token(page, places.slips[0], label, {Icon::kPale, "dec.fillw"}, Button::kSlip, 0,
                     !decorating.black);
        choice_token(page, places.slips[1], label, {Icon::kDark, "dec.fillb"}, Button::kSlip, 1,
                     decorating.black);
    } else {
        const Rect rect = page.on_ledge(places.size);
        page.stepper(rect, kToolChoices[static_cast<std::size_t>(decorating.tool)].icon,
                     {kMostBrush, decorating.brush}, Button::kToolLess, Button::kToolMore,
                     page.named("dec.size"), page.right_to_left());
        page.label({rect.x, rect.bottom() + 8.0F, rect.width, label}, page.t("dec.size"));
    }
    choice_token(
        page, places.turning, label,
        decorating.turns ? DrawingChoice{Icon::kTurns, "dec.turn"} : DrawingChoice{Icon::kRests, "dec.rest"},
        Button::kTurning, 0, false, kLessWideLabel);
    choice_token(page, places.undo, label, {Icon::kUndo, "ctl.undo"}, Button::kUndo, 0, false, kWideLabel);
    if (is_square) {
        page.token(page.on_ledge(places.clear), Look::kToken, Button::kClear, page.named("dec.clear"), 0,
                   Icon::kWipe);
    } else {
        choice_token(page, places.clear, label, {Icon::kWipe, "dec.clear"}, Button::kClear, 0, false);
    }
    const bool is_plain = decorating.strokes == 0;
    page.token(page.on_ledge(places.done), Look::kPrimary, Button::kDone,
               page.named(is_plain ? "dec.plain" : "dec.done"));
    // With low controls the languages' token is opposite the brush's keys.
    static_cast<void>(page.languages_token(low_languages(page)));
}

std::string_view spoken_while_decorating(const State& state) {
    const Decorating& decorating = state.decorating;
    if (decorating.strokes == 0 && !decorating.touched && decorating.tool == 0) return "dec.title";
    constexpr std::array<std::string_view, kDrawingTools> kTools{
        "dec.finger.h", "dec.iron.h", "dec.cobalt.h", "dec.inlay.h", "dec.white.h", "dec.motif.how"};
    return kTools[static_cast<std::size_t>(decorating.tool)];
}

std::string title_of_decorating(const TitleFacts& facts) {
    return fmt::format(" - {} strokes", facts.now.decorating.strokes);
}

}  // namespace

extern constinit const Step kDecorateStep{.screen = Screen::kDecorate,
                                          .name = "decorate",
                                          .enter = enter_decorate,
                                          .press = press_decorate,
                                          .take = take_decorate,
                                          .draw = draw_decorate,
                                          .spoken = spoken_while_decorating,
                                          .title = title_of_decorating,
                                          .camera = Camera::kNear,
                                          .shows_scene = true,
                                          .finger = Finger::kBrush};

}  // namespace onggi::visit

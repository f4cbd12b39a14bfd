// Trimming the foot of a leather-hard pot, which stands on its rim. It is offered if the foot has spare clay.
// The ledge shows the removed mass.
#include <fmt/format.h>

#include <algorithm>

#include "game/screens/page/ledge_parts.h"
#include "game/visit/flow/turn.h"

namespace onggi::visit {
namespace {

using ui::Rect;

void enter_trim(Turn& turn) {
    turn.state.trimming = {};
    turn.add(effect::BeginTrim{});
}

void end_trimming(Turn& turn) {
    turn.add(effect::EndTrim{.took_clay = turn.state.trimming.touched});
    turn.show(Screen::kDecorate);
}

void press_trim(Turn& turn, const event::Pressed& event) {
    Trimming& trimming = turn.state.trimming;
    Throwing& throwing = turn.state.throwing;
    switch (event.button) {
        case Button::kUndo:
            turn.add(effect::Undo{});
            break;
        case Button::kToolLess:
        case Button::kToolMore:
            change(trimming.loop, event.button == Button::kToolMore ? 1 : -1, kMostTool);
            break;
        case Button::kSpeedLess:
        case Button::kSpeedMore:
            change(throwing.speed, event.button == Button::kSpeedMore ? 1 : -1, kMostSpeed);
            break;
        case Button::kSkip:
        case Button::kDone:
            end_trimming(turn);
            break;
        default:
            if (moves_hand(event.button)) turn.add(effect::MoveHand{event.button});
            break;
    }
}

void take_trim(Turn& turn, const Event& event) {
    const auto* const trimmed = std::get_if<event::Trimmed>(&event);
    if (trimmed == nullptr) return;
    Trimming& trimming = turn.state.trimming;
    trimming.taken_g = std::max(0, trimmed->taken_g);
    trimming.touched = trimming.touched || trimmed->taken_g > 0;
}

Rect foot_box(const Page& page) {
    const float top = ledge_top(page);
    const bool padded = page.view().scans || page.is_low();
    return page.by_shape(Rect{350.0F, 56.0F, padded ? 530.0F : 580.0F, top - 70.0F},
                         Rect{290.0F, 114.0F, padded ? 420.0F : 480.0F, top - 124.0F},
                         Rect{90.0F, 240.0F, padded ? 330.0F : 550.0F, top - 260.0F});
}

// Writes the line beside the removed mass, if the ledge has room.
void words_on_ledge(Page& page, const Rect& grams, const Rect& line) {
    const Trimming& trimming = page.view().state.trimming;
    if (trimming.touched) {
        page.words(page.on_ledge(grams),
                   {.text = page.t("trim.weight", page.digits(std::to_string(trimming.taken_g))),
                    .type = design::bold(30.0F, 40.0F),
                    .align = along_ledge(page)});
    }
    page.words(page.on_ledge(line), {.text = page.t("trim.sub"),
                                     .type = design::kPaper,
                                     .colour = design::kSlip3,
                                     .align = along_ledge(page)});
}

void draw_trim(Page& page) {
    const View& view = page.view();
    const Trimming& trimming = view.state.trimming;
    const float width = page.width();
    const float top = ledge_top(page);
    const float y = row_y(page);
    page.keep_clear(foot_box(page));
    page.scene_ends();
    page.ledge(top);
    page.allow_cue();
    if (!trimming.touched) {
        const bool tall = page.is_tall();
        const bool square = page.is_square();
        const Rect most{square ? 20.0F : 32.0F, tall ? 32.0F : 112.0F, page.by_shape(304.0F, 250.0F, 430.0F),
                        tall ? 196.0F : 300.0F};
        add_paper(page, page.mirrored(most),
                  {{.text = page.t("trim.title"), .type = design::kHeading, .colour = design::kInk},
                   {.text = page.t("trim.line"), .type = design::kPaper, .colour = design::kInk2}});
    }
    if (view.scans || page.is_low()) add_hand_pad(page);
    const Setting loop{Icon::kTrimmer, "trim.tool",       kMostTool,
                       trimming.loop,  Button::kToolLess, Button::kToolMore};
    const Setting speed = speed_setting(view.state.throwing);
    const auto leave = [&](const Rect& place) {
        if (trimming.touched) return;
        page.token(page.on_ledge(place), Look::kOutline, Button::kSkip, page.named("trim.auto"));
    };
    const auto done = [&](const Rect& place) {
        page.token(page.on_ledge(place), trimming.touched ? Look::kPrimary : Look::kToken, Button::kDone,
                   page.named("trim.done"));
    };
    switch (page.shape()) {
        case Shape::kWide:
            words_on_ledge(page, {34.0F, top + 16.0F, 370.0F, 44.0F},
                           {34.0F, top + (trimming.touched ? 60.0F : 30.0F), 370.0F,
                            (trimming.touched ? 74.0F : 104.0F) + growth(page).labels});
            add_round(page, {436.0F, y, 70.0F, 66.0F}, Icon::kUndo, Button::kUndo, "ctl.undo", 112.0F);
            add_stepper(page, {542.0F, y, 156.0F, 66.0F}, loop, false);
            add_stepper(page, {718.0F, y, 156.0F, 66.0F}, speed, false);
            leave({894.0F, y, 180.0F, 66.0F});
            done({width - 188.0F, y, 156.0F, 66.0F});
            break;
        case Shape::kSquare:
            words_on_ledge(page, {32.0F, top + 24.0F, 250.0F, 50.0F + growth(page).caption},
                           {trimming.touched ? 300.0F : 32.0F, top + 26.0F,
                            width - (trimming.touched ? 332.0F : 64.0F), 56.0F + growth(page).caption});
            add_round(page, {32.0F, y, 70.0F, 66.0F}, Icon::kUndo, Button::kUndo, "ctl.undo", 112.0F);
            add_stepper(page, {150.0F, y, 156.0F, 66.0F}, loop, false);
            add_stepper(page, {340.0F, y, 156.0F, 66.0F}, speed, false);
            leave({540.0F, y, 200.0F, 66.0F});
            done({width - 220.0F, y, 200.0F, 66.0F});
            break;
        case Shape::kTall: {
            const float below = second_row_y(page);
            words_on_ledge(page, {32.0F, top + 20.0F, 260.0F, 50.0F + growth(page).caption},
                           {trimming.touched ? 310.0F : 32.0F, top + 22.0F,
                            width - (trimming.touched ? 342.0F : 64.0F), 84.0F + growth(page).caption});
            add_round(page, {32.0F, y, 84.0F, 66.0F}, Icon::kUndo, Button::kUndo, "ctl.undo", 120.0F);
            add_stepper(page, {278.0F, y, 164.0F, 66.0F}, loop, false);
            add_stepper(page, {width - 196.0F, y, 164.0F, 66.0F}, speed, false);
            leave({32.0F, below, 300.0F, 80.0F});
            done({width - 300.0F, below, 268.0F, 80.0F});
            break;
        }
    }
    static_cast<void>(page.languages_token(low_languages(page)));
}

std::string_view spoken_while_trimming(const State& /*state*/) {
    return "trim.title";
}

std::string title_of_trimming(const TitleFacts& facts) {
    return fmt::format(" - {} g", facts.now.trimming.taken_g);
}

}  // namespace

extern constinit const Step kTrimStep{.screen = Screen::kTrim,
                                      .name = "trim",
                                      .enter = enter_trim,
                                      .press = press_trim,
                                      .take = take_trim,
                                      .draw = draw_trim,
                                      .spoken = spoken_while_trimming,
                                      .title = title_of_trimming,
                                      .camera = Camera::kThrowing,
                                      .shows_scene = true,
                                      .finger = Finger::kFoot,
                                      .turns_wheel = true};

}  // namespace onggi::visit

// The ledge under the clay: the three steps of the lesson, tokens and steppers; while the wheel's own hands
// show a step, how to take over.
#include <fmt/format.h>

#include <array>

#include "game/screens/page/ledge_parts.h"
#include "game/screens/screens.h"

namespace onggi::screens {
namespace {

using kiosk::Button;
using ui::Rect;

constexpr std::array kStepIcons{Icon::kStepPress, Icon::kStepOpen, Icon::kStepRaise};
constexpr std::array kStepKeys{"step.press", "step.open", "step.raise"};

// Three sections of the clay: what is done, what is next, what comes.
void steps(Page& page, float x, float y, float pitch, int done) {
    for (int i = 0; i < kiosk::kTeachingSteps; ++i) {
        const bool current = i == done;
        const float side = current ? 64.0F : 50.0F;
        const float left = x + static_cast<float>(i) * pitch;
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

// The steps, and one line below or beside them.
void teaching(Page& page, const std::string& text) {
    if (page.view().state.throwing.jar.step != kiosk::JarStep::kNone) return add_jar_steps(page);
    const float y = ledge_top(page);
    const int done = page.view().state.throwing.steps_done;
    if (page.shape() == Shape::kWide) {
        steps(page, 28.0F, y + 16.0F, 64.0F, done);
    } else {
        steps(page, 32.0F, y + (page.is_tall() ? 24.0F : 16.0F), 74.0F, done);
    }
    add_step_caption(page, text, 350.0F, 282.0F);
}

// The wall's section with its thinnest place.
void gauge(Page& page, const Rect& rect) {
    ui::Sketch sketch;
    constexpr float kDrawnWidth = 236.0F;
    const float scale = rect.width / kDrawnWidth;
    const ui::Placing placing{.at = {-64.0F * scale, 0.0F}, .scale = vec2(scale)};
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
    page.sprite({rect.x, rect.y, rect.width, 70.0F * scale}, std::move(sketch));
    page.words({rect.x, rect.y + 70.0F, rect.width, 36.0F},
               {.text = page.measure(fmt::format("{:.1f}", page.view().thinnest_mm), "unit.mm"),
                .type = design::kName,
                .colour = ui::hex(0xffd9b8),
                .align = ui::Align::kCentre});
}

// The ring comes to what is done to the clay first, and to the settings last.
void controls(Page& page) {
    const Setting water = water_setting(page.view().state.throwing);
    const Setting speed = speed_setting(page.view().state.throwing);
    const kiosk::JarMaking& jar = page.view().state.throwing.jar;
    const bool is_jar = jar.step != kiosk::JarStep::kNone;
    const char* const done_key = jar.step == kiosk::JarStep::kFirstBowl ? "moon.aside" : "ctl.done";
    const bool is_bowl_to_come = is_jar && jar.step != kiosk::JarStep::kSeam && !jar.is_bowl;
    const Look done_look = is_bowl_to_come ? Look::kToken : Look::kPrimary;
    const float width = page.width();
    const float y = row_y(page);
    if (page.is_tall()) {
        const float below = second_row_y(page);
        add_round(page, {280.0F, below, 84.0F, 66.0F}, Icon::kShow, Button::kShowMe, "show.me", 120.0F);
        add_round(page, {32.0F, below, 84.0F, 66.0F}, Icon::kAgain, Button::kNewClay, "ctl.again", 120.0F);
        add_round(page, {156.0F, below, 84.0F, 66.0F}, Icon::kUndo, Button::kUndo, "ctl.undo", 120.0F);
        page.token(page.on_ledge({width - 300.0F, below, 268.0F, 80.0F}), done_look, Button::kDone,
                   page.t(done_key), 0, is_jar ? std::nullopt : std::optional(Icon::kDone));
        add_held_token(page, {32.0F, y, 116.0F, 66.0F}, 164.0F);
        add_stepper(page, {278.0F, y, 164.0F, 66.0F}, water, false);
        add_stepper(page, {width - 196.0F, y, 164.0F, 66.0F}, speed, false);
        return;
    }
    if (page.is_square()) {
        add_round(page, {32.0F, y, 84.0F, 66.0F}, Icon::kShow, Button::kShowMe, "show.me", 120.0F);
        add_round(page, {153.0F, y, 70.0F, 66.0F}, Icon::kAgain, Button::kNewClay, "ctl.again", 112.0F);
        add_round(page, {255.0F, y, 70.0F, 66.0F}, Icon::kUndo, Button::kUndo, "ctl.undo", 96.0F);
        page.token(page.on_ledge({width - 152.0F, y, 132.0F, 66.0F}), done_look, Button::kDone,
                   page.t(done_key));
        add_held_token(page, {352.0F, y, 100.0F, 66.0F}, 116.0F);
        add_stepper(page, {width - 500.0F, y, 164.0F, 66.0F}, water, false);
        add_stepper(page, {width - 328.0F, y, 164.0F, 66.0F}, speed, false);
        return;
    }
    if (is_jar) {
        add_round(page, {290.0F, y, 84.0F, 66.0F}, Icon::kShow, Button::kShowMe, "show.me", 120.0F);
    } else {
        page.token(page.on_ledge({232.0F, y, 172.0F, 66.0F}), Look::kToken, Button::kShowMe,
                   page.t("show.me"), 0, Icon::kShow);
    }
    add_round(page, {416.0F, y, 70.0F, 66.0F}, Icon::kAgain, Button::kNewClay, "ctl.again", 112.0F);
    add_round(page, {518.0F, y, 70.0F, 66.0F}, Icon::kUndo, Button::kUndo, "ctl.undo", 96.0F);
    page.token(page.on_ledge({width - 188.0F, y, 156.0F, 66.0F}), done_look, Button::kDone, page.t(done_key));
    add_held_token(page, {width - 668.0F, y, 116.0F, 66.0F}, 132.0F);
    add_stepper(page, {width - 524.0F, y, 156.0F, 66.0F}, water, false);
    add_stepper(page, {width - 356.0F, y, 156.0F, 66.0F}, speed, false);
}

// All rests but what takes over; and touching the clay does.
void show_controls(Page& page) {
    const Setting water = water_setting(page.view().state.throwing);
    const Setting speed = speed_setting(page.view().state.throwing);
    const float width = page.width();
    const float y = row_y(page);
    const Words line{.text = page.t("show.line"),
                     .type = design::kPaper,
                     .colour = design::kSlip3,
                     .align = along_ledge(page)};
    const auto my_turn = [&](const Rect& place) {
        page.token(page.on_ledge(place), Look::kPrimary, Button::kMyTurn, page.t("show.mine"), 0,
                   Icon::kHand);
    };
    if (page.is_tall()) {
        add_stepper(page, {278.0F, y, 164.0F, 66.0F}, water, true);
        add_stepper(page, {width - 196.0F, y, 164.0F, 66.0F}, speed, true);
        const float below = second_row_y(page);
        page.words(page.on_ledge({32.0F, below + 8.0F, width - 348.0F, 108.0F}), line);
        my_turn({width - 300.0F, below, 268.0F, 80.0F});
        return;
    }
    const bool square = page.is_square();
    const float right = width - (square ? 20.0F : 32.0F);
    add_stepper(page, {right - 584.0F, y, 164.0F, 66.0F}, water, true);
    add_stepper(page, {right - 408.0F, y, 164.0F, 66.0F}, speed, true);
    const float left = square ? 32.0F : 276.0F;
    const float high = 70.0F + (square ? growth(page).labels : 0.0F);  // else it ends above the caption
    page.words(page.on_ledge({left, y + 2.0F, right - 608.0F - left, high}), line);
    my_turn({right - 220.0F, y - 4.0F, 220.0F, 74.0F});
}

}  // namespace

void add_throw_ledge(Page& page) {
    const View& view = page.view();
    const kiosk::Throwing& throwing = view.state.throwing;
    if (throwing.shown) {
        teaching(page, page.t("show.on"));
        show_controls(page);
        return;
    }
    if (throwing.jar.step == kiosk::JarStep::kAside) return add_aside_ledge(page);
    if (throwing.tray) return add_tool_tray(page);
    if (throwing.held == kiosk::Held::kWire) return add_wire_ledge(page);
    const bool is_thin = throwing.warning == kiosk::Warning::kThin && view.thinnest_mm > 0.0;
    if (is_thin && page.shape() == Shape::kWide) {
        gauge(page, page.on_ledge({34.0F, ledge_top(page) + 26.0F, 180.0F, 104.0F}));
    } else {
        const int done = throwing.steps_done;
        teaching(page, page.t(done < kiosk::kTeachingSteps ? kStepKeys[static_cast<std::size_t>(done)]
                                                           : "step.own"));
    }
    controls(page);
}

}  // namespace onggi::screens

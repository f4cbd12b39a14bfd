// Throwing: the clay, with only the stage's cue over it. The ledge holds the three steps of the lesson,
// tokens and steppers, and the tools (hand, rib, sponge, wire); during a demonstration, the button to take
// over. A warning shows a sign on the pot, a card and a section of the wall.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "game/screens/forces.h"
#include "game/screens/page/ledge_parts.h"
#include "game/visit/jar/jar.h"
#include "game/visit/throw/throw.h"

namespace onggi::visit {
namespace {

using ui::Rect;

// Adds a small sign at the end of a token.
void add_sign(Page& page, const Rect& rect, Icon icon, int target) {
    constexpr float kSignSide = 26.0F;
    ui::Sketch sketch;
    add_icon(sketch, icon, {0.0F, 0.0F}, kSignSide, design::kInk);
    const float x = page.right_to_left() ? rect.x + 8.0F : rect.right() - kSignSide - 8.0F;
    page.sprite({x, rect.centre().y - 0.5F * kSignSide - 3.0F, kSignSide, kSignSide}, std::move(sketch),
                target);
}

// Writes the task and one line about the held tool.
void add_lines(Page& page, const Rect& place, const std::string& title, const std::string& line) {
    const Rect rect = page.on_ledge(place);
    const Words head{.text = title, .type = design::kName, .align = along_ledge(page)};
    const float room = line.empty() ? rect.height : 0.46F * rect.height;
    const float height = page.words({rect.x, rect.y, rect.width, room}, head);
    if (line.empty()) return;
    page.words({rect.x, rect.y + height + 2.0F, rect.width, rect.height - height - 2.0F},
               {.text = line, .type = design::kLabel, .colour = design::kSlip3, .align = along_ledge(page)});
}

void add_back(Page& page, const Rect& place) {
    page.token(page.on_ledge(place), Look::kOutline, Button::kTools, page.t("ctl.back"));
}

constexpr std::array kStepIcons{Icon::kStepPress, Icon::kStepOpen, Icon::kStepRaise};
constexpr std::array kStepKeys{"step.press", "step.open", "step.raise"};

// Draws three sections of the clay, for the steps that are done, current and to come.
void steps(Page& page, float x, float y, float pitch, int done) {
    for (int i = 0; i < kTeachingSteps; ++i) {
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

// Draws the steps and one line below or beside them.
void teaching(Page& page, const std::string& text) {
    if (page.view().state.throwing.jar.step != JarStep::kNone) return add_jar_steps(page);
    const float y = ledge_top(page);
    const int done = page.view().state.throwing.steps_done;
    if (page.shape() == Shape::kWide) {
        steps(page, 28.0F, y + 16.0F, 64.0F, done);
    } else {
        steps(page, 32.0F, y + (page.is_tall() ? 24.0F : 16.0F), 74.0F, done);
    }
    add_step_caption(page, text, 350.0F, 282.0F);
}

// Draws the wall's section with its thinnest place marked.
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

void add_held_token(Page& page, const Rect& place, float label_width) {
    const TrayTool& held = tray_tool(page.view().state.throwing.held);
    const int target = add_round(page, place, held.icon, Button::kTools, held.name_key, label_width);
    add_sign(page, page.on_ledge(place), Icon::kMore, target);
}

// Adds the controls in focus order: first actions on the clay, then settings.
void controls(Page& page) {
    const Setting water = water_setting(page.view().state.throwing);
    const Setting speed = speed_setting(page.view().state.throwing);
    const JarMaking& jar = page.view().state.throwing.jar;
    const bool is_jar = jar.step != JarStep::kNone;
    const char* const done_key = jar.step == JarStep::kFirstBowl ? "moon.aside" : "ctl.done";
    const bool is_bowl_to_come = is_jar && jar.step != JarStep::kSeam && !jar.is_bowl;
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

// Disables all controls except the one for taking over. Touching the clay takes over too.
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
    // otherwise the words end above the caption
    const float high = 70.0F + (square ? growth(page).labels : 0.0F);
    page.words(page.on_ledge({left, y + 2.0F, right - 608.0F - left, high}), line);
    my_turn({right - 220.0F, y - 4.0F, 220.0F, 74.0F});
}

float ledge_y(const Page& page) {
    return screens::ledge_y(page.shape(), page.height(), page.view().state.comfort);
}

// Visitors with low controls or a single switch get buttons in place of drags.
bool has_hand_pad(const View& view) {
    return view.state.comfort.reach || view.scans;
}

// The area of the pot, tool and hands; only cards may put words there.
Rect pot_box(const Page& page) {
    if (page.view().state.comfort.reach)
        return {0.38F * page.width(), 0.42F * page.height(), 0.2F * page.width(),
                ledge_y(page) - 0.42F * page.height()};
    const bool padded = has_hand_pad(page.view());  // the pad covers the wheel's edge beside the pot
    const float top = ledge_y(page);
    return page.by_shape(Rect{340.0F, 56.0F, 600.0F, top - 70.0F},
                         Rect{260.0F, 114.0F, padded ? 450.0F : 510.0F, top - 124.0F},
                         Rect{90.0F, 240.0F, padded ? 330.0F : 550.0F, top - 260.0F});
}

// Draws the target's outline, in the scene's pixels; never mirrored.
void outline(Page& page) {
    const View& view = page.view();
    const float u = 1.0F / page.px_per_u();
    for (const std::vector<vec2>& line : view.outline_px) {
        std::vector<vec2> points;
        for (const vec2& point : line)
            points.push_back(point * u);
        page.dotted(points);
    }
}

// Draws the bowl that was set aside.
void bowl_aside(Page& page) {
    const View& view = page.view();
    if (!view.aside) return;
    const vec2 foot = view.aside_foot_px / page.px_per_u();
    const float scale = view.aside_px_per_mm / page.px_per_u();
    const float reach = view.aside->radius_mm() * scale;
    // relative to the museum's evening light, in which such pictures are drawn
    constexpr float kDaylight = 1.25F;
    if (foot.x < -0.4F * reach || foot.y > ledge_y(page)) return;
    page.pot(*view.aside, finish::wet_clay(), scale, foot, kDaylight);
}

// Rings the tools on the bench that can be picked up.
void bench_rings(Page& page) {
    const float u = 1.0F / page.px_per_u();
    for (const BenchTool& tool : page.view().bench) {
        const vec2 size = tool.size_px * u;
        const vec2 corner = tool.centre_px * u - 0.5F * size;
        if (corner.y + size.y > ledge_y(page)) continue;
        const float r = 0.42F * std::min(size.x, size.y);
        constexpr float kMargin = 6.0F;
        const float left = kMargin;
        const float top = kMargin;
        const float right = kMargin + size.x;
        const float low = kMargin + size.y;
        const std::string path = fmt::format(
            "M{:.1f} {:.1f} H{:.1f} Q{:.1f} {:.1f} {:.1f} {:.1f} V{:.1f} Q{:.1f} {:.1f} {:.1f} {:.1f} "
            "H{:.1f} "
            "Q{:.1f} {:.1f} {:.1f} {:.1f} V{:.1f} Q{:.1f} {:.1f} {:.1f} {:.1f} Z",
            left + r, top, right - r, right, top, right, top + r, low - r, right, low, right - r, low,
            left + r, left, low, left, low - r, top + r, left, top, left + r, top);
        ui::Sketch sketch;
        sketch.add(ui::Shape{
            .path = path, .stroke = design::kNight.with_alpha(0.55F), .stroke_width = 7.0F, .dash = 13.0F});
        sketch.add(ui::Shape{.path = path, .stroke = design::kOutline, .stroke_width = 4.4F, .dash = 13.0F});
        page.sprite(
            {corner.x - kMargin, corner.y - kMargin, size.x + 2.0F * kMargin, size.y + 2.0F * kMargin},
            std::move(sketch));
    }
}

void warning_card(Page& page) {
    const View& view = page.view();
    const bool tall = page.is_tall();
    const bool square = page.is_square();
    const bool low = has_hand_pad(view) && page.shape() == Shape::kWide;
    const float width = page.width();
    // With low controls the card is opposite the hand's keys.
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
    const char* const key = view.state.throwing.warning == Warning::kThin  ? "warn.thin"
                            : view.state.throwing.warning == Warning::kWet ? "warn.wet"
                                                                           : "warn.fast";
    page.card(card, design::kHanji, design::kHanji);
    const Rect inner{card.x + 20.0F, card.y + 14.0F, card.width - 40.0F, card.height - 22.0F};
    page.fitted_words(
        inner, page.fitted(
                   {{.text = page.t(key), .type = design::bold(30.0F, 40.0F), .colour = design::kRust},
                    {.text = page.t(std::string(key) + "2"), .type = {28.0F, 38.0F}, .colour = design::kInk}},
                   {inner.width, inner.height + 4.0F}, 4.0F));
}

// Adds a chip as wide as its words, at most as `rect`; more lines make it higher.
void chip(Page& page, const Rect& rect, const std::string& text) {
    const Words words{.text = text, .type = design::kLabel, .align = ui::Align::kCentre};
    const float wide = std::min(rect.width, page.words_width(words) * page.text_scale() + 44.0F);
    const float least = page.words_size(words, 1.0F, wide - 36.0F).height + 16.0F;
    const Rect body{rect.centre().x - 0.5F * wide, rect.y, wide, std::max(rect.height, least)};
    ui::Sketch sketch;
    sketch.add(ui::Box{
        {0.0F, 0.0F, body.width, body.height}, 24.0F, ui::Fill::flat(design::kNight.with_alpha(0.86F))});
    page.sprite(body, std::move(sketch));
    page.words({body.x + 18.0F, body.y + 8.0F, body.width - 36.0F, body.height - 14.0F}, words, true);
}

// Passes the stage the labels that say why the clay follows the finger only in part.
void add_guards(Page& page) {
    for (int guard = 1; guard < kCueGuardCount; ++guard) {
        constexpr float kMostWide = 420.0F;
        Words words{.text = page.t(key_of(static_cast<CueGuard>(guard))), .type = design::kLabel};
        const float scale = std::max(1.0F, std::min(page.text_scale(), kMostWide / page.words_width(words)));
        words.type = words.type.times(scale);
        page.keep_guard_words(static_cast<CueGuard>(guard), page.loose_words(words, 0.0F, true));
    }
}

void add_tool_tray(Page& page) {
    const Throwing& throwing = page.view().state.throwing;
    const std::string& title = page.t("tool.title");
    const std::string& line = page.t(tray_tool(throwing.held).line_key);
    const Setting size = size_setting(throwing);
    const float width = page.width();
    const float top = ledge_top(page);
    const float y = row_y(page);
    constexpr std::size_t kAbove = 3;  // tools in the first row of a tall screen
    const auto choices = [&](float x, float row, float pitch, float wide, std::span<const TrayTool> all) {
        for (const TrayTool& one : all) {
            add_choice(page, {x, row, wide, 66.0F},
                       {.icon = one.icon,
                        .key = one.name_key,
                        .button = Button::kTakeTool,
                        .value = static_cast<int>(tray_place(one.tool)),
                        .chosen = one.tool == throwing.held},
                       label_height(page), 0.5F * (pitch - 8.0F - wide));
            x += pitch;
        }
    };
    switch (page.shape()) {
        case Shape::kWide:
            add_lines(page, {34.0F, top + 20.0F, 306.0F, 116.0F + growth(page).labels}, title, line);
            choices(358.0F, y, 146.0F, 130.0F, kTray);
            add_stepper(page, {942.0F, y, 160.0F, 66.0F}, size, false);
            add_back(page, {width - 162.0F, y, 130.0F, 66.0F});
            return;
        case Shape::kSquare:
            add_lines(page, {32.0F, top + 12.0F, width - 64.0F, 74.0F + growth(page).caption}, title, line);
            choices(32.0F, y, 130.0F, 112.0F, kTray);
            add_stepper(page, {width - 384.0F, y, 164.0F, 66.0F}, size, false);
            add_back(page, {width - 170.0F, y, 138.0F, 66.0F});
            return;
        case Shape::kTall:
            add_lines(page, {32.0F, top + 24.0F, width - 64.0F, 84.0F + growth(page).caption}, title, line);
            choices(32.0F, y, 228.0F, 200.0F, std::span(kTray).first(kAbove));
            choices(32.0F, second_row_y(page), 228.0F, 200.0F, std::span(kTray).subspan(kAbove));
            add_stepper(page, {260.0F, second_row_y(page), 200.0F, 66.0F}, size, false);
            add_back(page, {width - 200.0F, second_row_y(page), 168.0F, 66.0F});
            return;
    }
}

// "Done" stays in its place, so that nobody who presses it again cuts the rim.
void add_wire_ledge(Page& page) {
    const std::string& how = page.t("wire.how");
    const float width = page.width();
    const float top = ledge_top(page);
    const float y = row_y(page);
    const auto undo = [&](const Rect& place) {
        add_round(page, place, Icon::kUndo, Button::kUndo, "ctl.undo", place.width + 26.0F);
    };
    const auto moves = [&](float x, float row) {
        for (const auto& [icon, button, key] : {std::tuple(Icon::kUp, Button::kHandUp, "ctl.up"),
                                                std::tuple(Icon::kDown, Button::kHandDown, "ctl.down")}) {
            add_round(page, {x, row, 84.0F, 66.0F}, icon, button, key, 94.0F);
            x += 98.0F;
        }
    };
    const auto cut_or_end = [&](const Rect& cut, const Rect& done) {
        page.token(page.on_ledge(cut), Look::kPrimary, Button::kCut, page.t("wire.cut"));
        page.token(page.on_ledge(done), Look::kToken, Button::kDone, page.t("ctl.done"));
    };
    switch (page.shape()) {
        case Shape::kWide:
            add_lines(page, {34.0F, top + 26.0F, width - 860.0F, 110.0F + growth(page).labels}, how, {});
            undo({width - 810.0F, y, 70.0F, 66.0F});
            add_held_token(page, {width - 710.0F, y, 116.0F, 66.0F}, 132.0F);
            moves(width - 570.0F, y);
            cut_or_end({width - 372.0F, y - 4.0F, 168.0F, 74.0F}, {width - 188.0F, y, 156.0F, 66.0F});
            return;
        case Shape::kSquare:
            add_lines(page, {32.0F, top + 24.0F, width - 64.0F, 60.0F + growth(page).caption}, how, {});
            undo({32.0F, y, 70.0F, 66.0F});
            add_held_token(page, {130.0F, y, 112.0F, 66.0F}, 128.0F);
            moves(268.0F, y);
            cut_or_end({470.0F, y - 4.0F, width - 470.0F - 172.0F, 74.0F},
                       {width - 152.0F, y, 132.0F, 66.0F});
            return;
        case Shape::kTall:
            add_lines(page, {32.0F, top + 24.0F, width - 64.0F, 84.0F + growth(page).caption}, how, {});
            add_held_token(page, {32.0F, y, 116.0F, 66.0F}, 164.0F);
            undo({240.0F, y, 84.0F, 66.0F});
            moves(width - 214.0F, y);
            cut_or_end({32.0F, second_row_y(page), width - 352.0F, 80.0F},
                       {width - 300.0F, second_row_y(page), 268.0F, 80.0F});
            return;
    }
}

// Asks whether the pot is really done. "Done" stays in its place, for whoever presses it again.
void add_question_ledge(Page& page) {
    const Throwing& throwing = page.view().state.throwing;
    const std::string question =
        page.t(question_key(throwing.asks), page.whole_mm(static_cast<double>(throwing.asked_mm)));
    const float width = page.width();
    const float top = ledge_top(page);
    const float y = row_y(page);
    const auto tokens = [&](const Rect& back, const Rect& done) {
        page.token(page.on_ledge(back), Look::kPrimary, Button::kToWheel, page.t("ask.back"), 0, Icon::kHand);
        page.token(page.on_ledge(done), Look::kToken, Button::kDone, page.t("ctl.done"));
    };
    switch (page.shape()) {
        case Shape::kWide:
            add_lines(page, {34.0F, top + 26.0F, width - 34.0F - 588.0F, 110.0F + growth(page).labels},
                      question, {});
            tokens({width - 556.0F, y - 4.0F, 350.0F, 74.0F}, {width - 188.0F, y, 156.0F, 66.0F});
            return;
        case Shape::kSquare:
            add_lines(page, {32.0F, top + 12.0F, width - 64.0F, 74.0F + growth(page).caption}, question, {});
            tokens({width - 520.0F, y, 350.0F, 66.0F}, {width - 152.0F, y, 132.0F, 66.0F});
            return;
        case Shape::kTall:
            add_lines(page, {32.0F, top + 24.0F, width - 64.0F, 108.0F + growth(page).caption}, question, {});
            tokens({32.0F, y, width - 64.0F, 80.0F}, {width - 300.0F, second_row_y(page), 268.0F, 80.0F});
            return;
    }
}

void add_throw_ledge(Page& page) {
    const View& view = page.view();
    const Throwing& throwing = view.state.throwing;
    if (throwing.shown) {
        teaching(page, page.t("show.on"));
        show_controls(page);
        return;
    }
    if (throwing.jar.step == JarStep::kAside) return add_aside_ledge(page);
    if (throwing.asks != DoneQuestion::kNone) return add_question_ledge(page);
    if (throwing.tray) return add_tool_tray(page);
    if (throwing.held == tool::Tool::kWire) return add_wire_ledge(page);
    const bool is_thin = throwing.warning == Warning::kThin && view.thinnest_mm > 0.0;
    if (is_thin && page.shape() == Shape::kWide) {
        gauge(page, page.on_ledge({34.0F, ledge_top(page) + 26.0F, 180.0F, 104.0F}));
    } else {
        const int done = throwing.steps_done;
        teaching(page,
                 page.t(done < kTeachingSteps ? kStepKeys[static_cast<std::size_t>(done)] : "step.own"));
    }
    controls(page);
}

// What the rib or the sponge does; as long as the lesson lasts, what it cannot do. The ledge says what the
// wire does, and a jar's card lies where these words would.
const char* held_notice(const Throwing& throwing) {
    const bool is_said = throwing.held != tool::Tool::kHand && throwing.held != tool::Tool::kWire;
    if (!is_said || throwing.tray || throwing.shown || throwing.jar.step != JarStep::kNone) return nullptr;
    return throwing.steps_done < kTeachingSteps ? "tool.only" : tray_tool(throwing.held).line_key;
}

}  // namespace

void draw_throw(Page& page) {
    const View& view = page.view();
    const float y = ledge_y(page);
    page.keep_clear(pot_box(page));
    page.scene_ends();
    bowl_aside(page);
    outline(page);
    bench_rings(page);
    const bool warned = view.state.throwing.warning != Warning::kNone;
    page.ledge(y);
    if (warned) {
        warning_card(page);
    } else {
        add_jar_card(page);
    }
    // In focus order, the hand's keys come before the button that ends the throwing.
    const Throwing& throwing = view.state.throwing;
    const bool works_clay = !throwing.shown && !throwing.tray && throwing.held != tool::Tool::kWire &&
                            throwing.jar.step != JarStep::kAside;
    if (has_hand_pad(view) && works_clay) add_hand_pad(page);
    add_throw_ledge(page);
    // With low controls the languages' token is above or opposite the hand's keys.
    const Rect languages = page.languages_token(low_languages(page, page.width() - 182.0F));
    add_forces(page);
    add_guards(page);
    if (view.can_look_in) page.look_in_token(languages);
    const float middle = 0.5F * page.width();
    if (view.wire_at_px) {
        const vec2 at = *view.wire_at_px / page.px_per_u();
        constexpr float kWide = 300.0F;
        constexpr float kHigh = 48.0F;
        const float x = std::min(at.x, page.width() - kWide - 16.0F);
        chip(page, {x, std::clamp(at.y + 20.0F, 120.0F, y - 2.0F * kHigh), kWide, kHigh},
             page.t("wire.off", page.digits(std::to_string(view.wire_off_mm))));
    }
    const char* const notice = view.state.device_lost    ? "dev.lost"
                               : view.state.force_rests  ? "dev.rest"
                               : throwing.jar.is_low     ? "moon.low"
                               : throwing.jar.rims_apart ? "moon.more"
                                                         : held_notice(throwing);
    if (notice != nullptr) {
        // Between the tokens at the top, or below them.
        const bool tall = page.is_tall();
        const float wide = tall ? page.width() - 64.0F : std::min(660.0F, page.width() - 600.0F);
        chip(page, {middle - 0.5F * wide, tall ? 104.0F : 28.0F, wide, 48.0F}, page.t(notice));
    } else if (!view.heard.empty()) {
        // If the hand's pad and the caption do not fit side by side, the caption is opposite the pad.
        const bool beside = page.is_tall() && has_hand_pad(view);
        chip(page,
             beside ? page.mirrored({24.0F, y - 58.0F, 390.0F, 48.0F})
                    : Rect{middle - 200.0F, y - 58.0F, 400.0F, 48.0F},
             page.t(view.heard));
    }
    if (view.state.throwing.target && !view.outline_px.empty() && throwing.jar.step == JarStep::kNone &&
        throwing.steps_done < kTeachingSteps && !warned && held_notice(throwing) == nullptr) {
        const float width = page.shape() == Shape::kWide ? 300.0F : 396.0F;
        chip(page, page.mirrored({24.0F, 28.0F, width, 84.0F}), page.t("out.target"));
    }
}

}  // namespace onggi::visit

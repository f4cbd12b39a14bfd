// What there is to hold while one throws: hand, rib, sponge and wire, on the ledge under the clay.
#include <array>

#include "game/screens/page/ledge_parts.h"
#include "game/screens/screens.h"

namespace onggi::screens {
namespace {

using kiosk::Button;
using kiosk::Held;
using ui::Rect;

constexpr std::array kHeldIcons{Icon::kHand, Icon::kRib, Icon::kSponge, Icon::kWire};
constexpr std::array kHeldKeys{"tool.hand", "tool.rib", "tool.sponge", "tool.wire"};
constexpr std::array kHeldLines{"tool.hand.line", "tool.rib.line", "tool.sponge.line", "tool.wire.line"};

std::size_t place_of(Held held) {
    return static_cast<std::size_t>(held);
}

// A small sign at the end of a token.
void add_sign(Page& page, const Rect& rect, Icon icon, int target) {
    constexpr float kSignSide = 26.0F;
    ui::Sketch sketch;
    add_icon(sketch, icon, {0.0F, 0.0F}, kSignSide, design::kInk);
    const float x = page.right_to_left() ? rect.x + 8.0F : rect.right() - kSignSide - 8.0F;
    page.sprite({x, rect.centre().y - 0.5F * kSignSide - 3.0F, kSignSide, kSignSide}, std::move(sketch),
                target);
}

// What is to be done, and one line on what is in the hand.
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

}  // namespace

void add_held_token(Page& page, const Rect& place, float label_width) {
    const std::size_t held = place_of(page.view().state.throwing.held);
    const int target = add_round(page, place, kHeldIcons[held], Button::kTools, kHeldKeys[held], label_width);
    add_sign(page, page.on_ledge(place), Icon::kMore, target);
}

void add_tool_tray(Page& page) {
    const kiosk::Throwing& throwing = page.view().state.throwing;
    const std::string& title = page.t("tool.title");
    const std::string& line = page.t(kHeldLines[place_of(throwing.held)]);
    const Setting size = size_setting(throwing);
    const float width = page.width();
    const float top = ledge_top(page);
    const float y = row_y(page);
    const auto choices = [&](float x, float row, float pitch, float wide, std::initializer_list<Held> all) {
        for (const Held held : all) {
            add_choice(page, {x, row, wide, 66.0F},
                       {.icon = kHeldIcons[place_of(held)],
                        .key = kHeldKeys[place_of(held)],
                        .button = Button::kTakeTool,
                        .value = static_cast<int>(held),
                        .chosen = held == throwing.held},
                       label_height(page), 0.5F * (pitch - 8.0F - wide));
            x += pitch;
        }
    };
    switch (page.shape()) {
        case Shape::kWide:
            add_lines(page, {34.0F, top + 20.0F, 306.0F, 116.0F + growth(page).labels}, title, line);
            choices(358.0F, y, 146.0F, 130.0F, {Held::kHand, Held::kRib, Held::kSponge, Held::kWire});
            add_stepper(page, {942.0F, y, 160.0F, 66.0F}, size, false);
            add_back(page, {width - 162.0F, y, 130.0F, 66.0F});
            return;
        case Shape::kSquare:
            add_lines(page, {32.0F, top + 12.0F, width - 64.0F, 74.0F + growth(page).caption}, title, line);
            choices(32.0F, y, 130.0F, 112.0F, {Held::kHand, Held::kRib, Held::kSponge, Held::kWire});
            add_stepper(page, {width - 384.0F, y, 164.0F, 66.0F}, size, false);
            add_back(page, {width - 170.0F, y, 138.0F, 66.0F});
            return;
        case Shape::kTall:
            add_lines(page, {32.0F, top + 24.0F, width - 64.0F, 84.0F + growth(page).caption}, title, line);
            choices(32.0F, y, 228.0F, 200.0F, {Held::kHand, Held::kRib, Held::kSponge});
            choices(32.0F, second_row_y(page), 228.0F, 200.0F, {Held::kWire});
            add_stepper(page, {260.0F, second_row_y(page), 200.0F, 66.0F}, size, false);
            add_back(page, {width - 200.0F, second_row_y(page), 168.0F, 66.0F});
            return;
    }
}

void add_wire_ledge(Page& page) {
    const kiosk::Throwing& throwing = page.view().state.throwing;
    const std::string& how = page.t("wire.how");
    const Setting speed = speed_setting(throwing);
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
    const auto cut = [&](const Rect& place) {
        page.token(page.on_ledge(place), Look::kPrimary, Button::kCut, page.t("wire.cut"));
    };
    switch (page.shape()) {
        case Shape::kWide:
            add_lines(page, {34.0F, top + 26.0F, 370.0F, 110.0F + growth(page).labels}, how, {});
            undo({424.0F, y, 70.0F, 66.0F});
            add_held_token(page, {522.0F, y, 116.0F, 66.0F}, 132.0F);
            add_stepper(page, {666.0F, y, 156.0F, 66.0F}, speed, false);
            moves(848.0F, y);
            cut({width - 232.0F, y - 4.0F, 200.0F, 74.0F});
            return;
        case Shape::kSquare:
            add_lines(page, {32.0F, top + 24.0F, width - 64.0F, 60.0F + growth(page).caption}, how, {});
            undo({32.0F, y, 70.0F, 66.0F});
            add_held_token(page, {130.0F, y, 112.0F, 66.0F}, 128.0F);
            add_stepper(page, {268.0F, y, 156.0F, 66.0F}, speed, false);
            moves(452.0F, y);
            cut({width - 296.0F, y - 4.0F, 264.0F, 74.0F});
            return;
        case Shape::kTall:
            add_lines(page, {32.0F, top + 24.0F, width - 64.0F, 84.0F + growth(page).caption}, how, {});
            add_held_token(page, {32.0F, y, 116.0F, 66.0F}, 164.0F);
            add_stepper(page, {278.0F, y, 164.0F, 66.0F}, speed, false);
            moves(width - 214.0F, y);
            undo({32.0F, second_row_y(page), 84.0F, 66.0F});
            cut({width - 300.0F, second_row_y(page), 268.0F, 80.0F});
            return;
    }
}

}  // namespace onggi::screens

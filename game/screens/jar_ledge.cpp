// The ledge while a jar of two bowls is made: its five steps, and what the steps between the throwings need.
#include <array>

#include "game/screens/page/ledge_parts.h"
#include "game/screens/screens.h"

namespace onggi::screens {
namespace {

using kiosk::Button;
using kiosk::JarStep;
using ui::Rect;

constexpr std::array kStepIcons{Icon::kJarFirst, Icon::kJarAside, Icon::kJarSecond, Icon::kJarJoin,
                                Icon::kJarWhole};
constexpr std::array kStepKeys{"moon.s1", "moon.s2", "moon.s3", "moon.s4", "moon.s5"};
static_assert(kStepIcons.size() == kiosk::kJarSteps && kStepKeys.size() == kiosk::kJarSteps);

int step_of(const Page& page) {
    return static_cast<int>(page.view().state.throwing.jar.step) - 1;
}

// Where the last token begins on a wide or square ledge, and on a tall one below.
Rect last_token(const Page& page, float wide) {
    if (page.is_tall()) return {page.width() - 300.0F, second_row_y(page), 268.0F, 80.0F};
    const float edge = page.is_square() ? 20.0F : 32.0F;
    return {page.width() - edge - wide, row_y(page) - 4.0F, wide, 74.0F};
}

}  // namespace

void add_jar_pictograms(Page& page, vec2 at, float pitch, int current) {
    constexpr float kSide = 42.0F;
    constexpr float kCurrentSide = 52.0F;
    constexpr float kField = 56.0F;
    for (int i = 0; i < kiosk::kJarSteps; ++i) {
        const bool is_current = i == current;
        const float side = is_current ? kCurrentSide : kSide;
        const float left = at.x + static_cast<float>(i) * pitch;
        const Icon icon = kStepIcons[static_cast<std::size_t>(i)];
        const float inset = 0.5F * (kField - side);
        ui::Sketch sketch;
        if (is_current || current < 0) {
            add_icon(sketch, icon, {inset, inset}, side, ui::hex(0xfff3d9));
        } else {
            const auto fill = i < current ? std::optional<ui::Colour>(ui::hex(0x8b6a48)) : std::nullopt;
            add_icon(sketch, icon, {inset, inset}, side, ui::hex(0xd6c6ac, 0.75F), fill);
        }
        if (is_current) sketch.add(ui::Box{{4.0F, 58.0F, 48.0F, 5.0F}, 3.0F, ui::Fill::flat(design::kAmber)});
        page.sprite(page.on_ledge({left, at.y, kField, kField + 8.0F}), std::move(sketch));
        if (i >= current) continue;
        ui::Sketch tick;
        add_icon(tick, Icon::kCheck, {0.0F, 0.0F}, 20.0F, design::kAmber);
        page.sprite(page.on_ledge({left + 38.0F, at.y - 10.0F, 20.0F, 20.0F}), std::move(tick));
    }
}

void add_jar_steps(Page& page) {
    constexpr float kPitch = 46.0F;
    const vec2 at(page.shape() == Shape::kWide ? 26.0F : 30.0F,
                  ledge_top(page) + page.by_shape(20.0F, 18.0F, 26.0F));
    add_jar_pictograms(page, at, kPitch, step_of(page));
    add_step_caption(page, page.t(kStepKeys[static_cast<std::size_t>(step_of(page))]), 232.0F, 290.0F);
}

void add_aside_ledge(Page& page) {
    add_jar_steps(page);
    const Rect next = last_token(page, 268.0F);
    page.token(page.on_ledge(next), Look::kPrimary, Button::kDone, page.t("moon.next"));
    const float x = page.is_tall() ? 32.0F : next.x - 120.0F;
    const float y = page.is_tall() ? second_row_y(page) : row_y(page);
    add_round(page, {x, y, 84.0F, 66.0F}, Icon::kUndo, Button::kUndo, "ctl.undo", 112.0F);
}

void add_join_ledge(Page& page) {
    add_jar_steps(page);
    const Rect join = last_token(page, 236.0F);
    const bool tall = page.is_tall();
    const float y = row_y(page);
    // Named once, below both.
    const float side_x = tall ? page.width() - 300.0F : join.x - 236.0F;
    const auto aside = [&](float x, Icon icon, Button button, const char* key) {
        page.token(page.on_ledge({x, y, 90.0F, 66.0F}), Look::kToken, button, page.t(key), 0, icon, false,
                   true);
    };
    // What is left on the screen is left of the jar, whichever way the ledge is read.
    const Rect first = page.on_ledge({side_x, y, 90.0F, 66.0F});
    const Rect second = page.on_ledge({side_x + 104.0F, y, 90.0F, 66.0F});
    const bool swaps = first.x > second.x;
    aside(swaps ? side_x + 104.0F : side_x, Icon::kLeft, Button::kHandLeft, "ctl.left");
    aside(swaps ? side_x : side_x + 104.0F, Icon::kRight, Button::kHandRight, "ctl.right");
    page.label(page.on_ledge({side_x - 14.0F, y + 74.0F, 222.0F, label_height(page)}), page.t("moon.side"));
    const float undo_x = tall ? 32.0F : side_x - 128.0F;
    add_round(page, {undo_x, tall ? second_row_y(page) : y, 84.0F, 66.0F}, Icon::kUndo, Button::kUndo,
              "ctl.undo", 112.0F);
    page.token(page.on_ledge(join), Look::kPrimary, Button::kJoinBowls, page.t("moon.join"));
}

}  // namespace onggi::screens

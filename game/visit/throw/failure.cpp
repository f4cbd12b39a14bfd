// The pot has collapsed. It stays visible on the turning wheel, and the visitor has three choices.
#include <algorithm>

#include "game/visit/jar/jar.h"
#include "game/visit/throw/throw.h"

namespace onggi::visit {
namespace {

using ui::Rect;

void draw_failure(Page& page) {
    const float width = page.width();
    const auto night = [](float alpha) { return design::kNight.with_alpha(alpha); };
    page.scene_ends();
    // Larger text makes the band deeper, so that the second line fits under the title.
    const float deep = 128.0F + 24.0F * static_cast<float>(page.view().state.comfort.text_size - 1);
    page.down({0.0F, 0.0F, width, deep}, night(0.93F), night(0.88F));
    page.down({0.0F, deep, width, 92.0F}, night(0.88F), night(0.0F));
    const float title = page.words(
        {60.0F, 18.0F, width - 120.0F, 76.0F},
        {.text = page.t("fail.title"), .type = design::serif(50.0F, 66.0F), .align = ui::Align::kCentre});
    page.words({60.0F, 20.0F + title, width - 120.0F, deep - 16.0F - title},
               {.text = page.t(failure_key(page.view().state.throwing.collapse)),
                .type = design::kBody,
                .colour = design::kSlip3,
                .align = ui::Align::kCentre});
    const float y = ledge_y(page.shape(), page.height(), page.view().state.comfort);
    page.ledge(y);
    const auto place = [&](int i) {
        if (page.is_tall()) {
            return Rect{60.0F, y + 240.0F - 100.0F * static_cast<float>(i), width - 120.0F, 84.0F};
        }
        const float gap = 24.0F;
        const float button = std::min(290.0F, (width - 64.0F - 2.0F * gap) / 3.0F);
        const float left = 0.5F * (width - 3.0F * button - 2.0F * gap);
        return page.mirrored({left + static_cast<float>(i) * (button + gap), y + 36.0F, button, 80.0F});
    };
    page.token(place(0), Look::kOutline, Button::kKeepSlump, page.named("fail.keep"));
    page.token(place(1), Look::kToken, Button::kNewClay, page.named("ctl.again"), 0, Icon::kAgain);
    page.token(place(2), Look::kPrimary, Button::kBeforeCollapse, page.named("fail.undo"), 0, Icon::kUndo);
}

void press_failure(Turn& turn, const event::Pressed& event) {
    if (event.button == Button::kBeforeCollapse) {
        Throwing& throwing = turn.state.throwing;
        throwing.warning = Warning::kNone;
        turn.state.pace.progress_s = turn.now_s;
        // At the same speed the clay would fly off again before the visitor could slow the wheel.
        if (throwing.collapse == Warning::kFast)
            throwing.speed = std::max(1, std::min(throwing.speed - 1, Throwing().speed));
        turn.add(effect::BeforeCollapse{});
        turn.show(Screen::kThrow);
    } else if (event.button == Button::kNewClay) {
        turn.show(Screen::kThrow);
        put_on_new_clay(turn);
    } else if (event.button == Button::kKeepSlump) {
        finish_throwing(turn);
    }
}

std::string_view spoken_of_failure(const State& /*state*/) {
    return "fail.title";
}

}  // namespace

extern constinit const Step kFailureStep{.screen = Screen::kFailure,
                                         .name = "failure",
                                         .press = press_failure,
                                         .draw = draw_failure,
                                         .spoken = spoken_of_failure,
                                         .shows_scene = true,
                                         .turns_wheel = true,
                                         .has_wet_clay = true};

}  // namespace onggi::visit

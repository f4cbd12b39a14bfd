#include "game/screens/screens.h"

namespace onggi::screens {

namespace {

void draw_screen(Page& page) {
    switch (page.view().state.screen) {
        case kiosk::Screen::kAttract:
            return draw_attract(page);
        case kiosk::Screen::kChoose:
            return draw_choose(page);
        case kiosk::Screen::kJarStart:
            return draw_jar_start(page);
        case kiosk::Screen::kThrow:
            return draw_throw(page);
        case kiosk::Screen::kJoin:
            return draw_join(page);
        case kiosk::Screen::kFailure:
            return draw_failure(page);
        case kiosk::Screen::kFiring:
            return draw_firing(page);
        case kiosk::Screen::kTrim:
            return draw_trim(page);
        case kiosk::Screen::kDecorate:
            return draw_decorate(page);
        case kiosk::Screen::kGlaze:
            return draw_glazes(page);
        case kiosk::Screen::kYourPot:
            return draw_your_pot(page);
        case kiosk::Screen::kKeep:
            return draw_keep(page);
        case kiosk::Screen::kResume:
            return draw_resume(page);
        case kiosk::Screen::kFault:
            return draw_fault(page);
    }
}

}  // namespace

Composition compose(const View& view, ui::Painter& painter, PaintingStore& store) {
    Page page(view, painter, store);
    if (view.only_forces) {
        add_forces(page);
        store.forget_unused();
        return page.take();
    }
    switch (view.state.panel) {
        case kiosk::Panel::kNone:
            draw_screen(page);
            if (view.closed) {
                const ui::Colour shade = ui::hex(0x000000, 0.85F);
                page.box({0.0F, 0.0F, page.width(), page.height()}, {shade, shade, shade, shade});
            }
            break;
        case kiosk::Panel::kLanguage:
            draw_language(page);
            break;
        case kiosk::Panel::kIdle:
            draw_idle(page);
            break;
        case kiosk::Panel::kPin:
            draw_pin(page);
            break;
        case kiosk::Panel::kStaff:
            draw_staff(page);
            break;
        case kiosk::Panel::kCard:
            draw_card_panel(page);
            break;
    }
    store.forget_unused();
    return page.take();
}

}  // namespace onggi::screens

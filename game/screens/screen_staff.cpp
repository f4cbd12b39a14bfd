// The staff's keypad and panel: plain, in English, values with ok, warn or fault as words. Not mirrored.
#include <array>
#include <string>

#include "game/screens/screens.h"

namespace onggi::screens {
namespace {

using kiosk::Button;
using ui::Rect;

constexpr ui::Colour kGround = ui::hex(0x202326);
constexpr ui::Colour kKey = ui::hex(0x2b3034);
constexpr ui::Colour kPale = ui::hex(0xeceff1);

void ground(Page& page) {
    page.covers();
    page.box({0.0F, 0.0F, page.width(), page.height()}, {kGround, kGround, kGround, kGround});
}

void key(Page& page, const Rect& rect, Button button, int value, const std::string& name,
         bool strong = false) {
    const int target = page.plain_target(rect, button, value, name);
    ui::Sketch sketch;
    const Rect body{0.0F, 0.0F, rect.width, rect.height};
    sketch.add(ui::Box{body, 6.0F, ui::Fill::flat(strong ? ui::hex(0x454c52) : kKey)});
    sketch.add(ui::Frame{body, 6.0F, 2.0F, ui::hex(0x79848c)});
    page.sprite(rect, std::move(sketch), target);
    page.fixed_words({rect.x + 8.0F, rect.y + 0.5F * rect.height - 17.0F, rect.width - 16.0F, 36.0F},
                     {.text = name,
                      .size = 26.0F,
                      .line = 34.0F,
                      .bold = strong,
                      .colour = kPale,
                      .align = ui::Align::kCentre,
                      .language = page.english()});
}

}  // namespace

void draw_pin(Page& page) {
    const kiosk::Staff& staff = page.view().state.staff;
    ground(page);
    const float middle = 0.5F * page.width();
    const int english = page.english();
    page.fixed_words({middle - 300.0F, 40.0F, 600.0F, 46.0F},
                     {.text = staff.was_wrong ? "That was not the PIN" : "Staff PIN",
                      .size = 30.0F,
                      .line = 40.0F,
                      .colour = kPale,
                      .align = ui::Align::kCentre,
                      .language = english});
    std::string dots;
    for (int i = 0; i < staff.digits; ++i)
        dots += "\u2022 ";
    page.fixed_words({middle - 300.0F, 92.0F, 600.0F, 60.0F}, {.text = dots.empty() ? "\u2013" : dots,
                                                               .size = 44.0F,
                                                               .line = 56.0F,
                                                               .colour = kPale,
                                                               .align = ui::Align::kCentre,
                                                               .language = english});
    for (int i = 0; i < 12; ++i) {
        const Rect rect{middle - 196.0F + static_cast<float>(i % 3) * 136.0F,
                        176.0F + static_cast<float>(i / 3) * 100.0F, 120.0F, 84.0F};
        if (i < 9) {
            key(page, rect, Button::kDigit, i + 1, std::to_string(i + 1));
        } else if (i == 9) {
            key(page, rect, Button::kPinClose, 0, "Close");
        } else if (i == 10) {
            key(page, rect, Button::kDigit, 0, "0");
        } else {
            key(page, rect, Button::kPinClear, 0, "Clear");
        }
    }
}

void draw_staff(Page& page) {
    const View& view = page.view();
    const float width = page.width();
    ground(page);
    const int english = page.english();
    const ui::Colour bar = ui::hex(0x30363b);
    page.box({0.0F, 0.0F, width, 62.0F}, {bar, bar, bar, bar});
    page.fixed_words({24.0F, 12.0F, 0.4F * width, 40.0F}, {.text = "Staff panel",
                                                           .size = 28.0F,
                                                           .line = 38.0F,
                                                           .bold = true,
                                                           .colour = kPale,
                                                           .language = english});
    page.fixed_words({0.4F * width, 14.0F, 0.6F * width - 24.0F, 38.0F}, {.text = view.staff_title,
                                                                          .size = 26.0F,
                                                                          .line = 36.0F,
                                                                          .colour = kPale,
                                                                          .align = ui::Align::kEnd,
                                                                          .language = english});
    constexpr std::array kPages{"Health", "Gallery", "Devices"};
    for (int i = 0; i < static_cast<int>(kPages.size()); ++i) {
        key(page, {24.0F + static_cast<float>(i) * 172.0F, 74.0F, 160.0F, 60.0F}, Button::kStaffPage, i,
            kPages[static_cast<std::size_t>(i)], i == view.state.staff.page);
    }
    const bool tall = page.shape() == Shape::kTall;
    const float list_width = tall ? width - 48.0F : width - 420.0F;
    float y = 152.0F;
    const float bottom = page.height() - (tall ? 500.0F : 20.0F);
    for (const StaffLine& line : view.staff_lines) {
        if (y + 42.0F > bottom) break;
        const bool has_delete = line.pot >= 0;
        page.fixed_words(
            {24.0F, y, 0.34F * list_width, 38.0F},
            {.text = line.name, .size = 26.0F, .line = 36.0F, .colour = kPale, .language = english});
        page.fixed_words(
            {24.0F + 0.35F * list_width, y, 0.47F * list_width, 38.0F},
            {.text = line.value, .size = 26.0F, .line = 36.0F, .colour = kPale, .language = english});
        if (has_delete) {
            key(page, {24.0F + list_width - 120.0F, y - 8.0F, 120.0F, 50.0F}, Button::kStaffDeletePot,
                line.pot, "Delete");
            y += 60.0F;
            continue;
        }
        const ui::Colour colour = line.status == "ok"     ? ui::hex(0x9fd8a8)
                                  : line.status == "warn" ? ui::hex(0xffcf7a)
                                                          : ui::hex(0xffa49a);
        page.fixed_words({24.0F + 0.84F * list_width, y, 0.16F * list_width, 38.0F}, {.text = line.status,
                                                                                      .size = 26.0F,
                                                                                      .line = 36.0F,
                                                                                      .bold = true,
                                                                                      .colour = colour,
                                                                                      .language = english});
        y += 42.0F;
    }
    struct Action {
        Button button;
        const char* name;
    };
    constexpr std::array kActions{Action{Button::kStaffForceTest, "Test the force"},
                                  Action{Button::kStaffSoundTest, "Test the sound"},
                                  Action{Button::kSoundLess, "Sound less"},
                                  Action{Button::kSoundMore, "Sound more"},
                                  Action{Button::kStaffRestart, "Restart the program"},
                                  Action{Button::kStaffQuit, "Quit"},
                                  Action{Button::kStaffClose, "Close the panel"}};
    for (std::size_t i = 0; i < kActions.size(); ++i) {
        const float step = 76.0F;
        const Rect rect =
            tall
                ? Rect{24.0F + (i % 2 == 0 ? 0.0F : 0.5F * width - 12.0F),
                       page.height() - 480.0F + static_cast<float>(i / 2) * step, 0.5F * width - 36.0F, 64.0F}
                : Rect{width - 24.0F - 350.0F, 152.0F + static_cast<float>(i) * step, 350.0F, 64.0F};
        key(page, rect, kActions[i].button, 0, kActions[i].name, kActions[i].button == Button::kStaffClose);
    }
}

}  // namespace onggi::screens

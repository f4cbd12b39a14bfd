// The staff's keypad and panel.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "game/visit/flow/flow.h"
#include "game/visit/flow/turn.h"

namespace onggi::visit {
namespace {

using ui::Rect;

constexpr ui::Colour kGround = ui::hex(0x202326);
constexpr ui::Colour kKey = ui::hex(0x2b3034);
constexpr ui::Colour kPale = ui::hex(0xeceff1);
constexpr ui::Colour kDim = ui::hex(0xb4bec6);
constexpr ui::Colour kBar = ui::hex(0x30363b);
constexpr ui::Colour kOk = ui::hex(0x9fd8a8);
constexpr ui::Colour kWarn = ui::hex(0xffcf7a);
constexpr ui::Colour kFault = ui::hex(0xffa49a);

// Extends beyond the screen's edges, so that no gap opens while the screen slides up.
void ground(Page& page) {
    constexpr float kBeyond = 16.0F;
    page.box({0.0F, -kBeyond, page.width(), page.height() + 2.0F * kBeyond},
             {kGround, kGround, kGround, kGround});
}

// of: what it is for, which its line tells those who see.
void key(Page& page, const Rect& rect, Button button, int value, const std::string& name, bool strong = false,
         const std::string& of = {}) {
    const int target = page.plain_target(rect, button, value, name);
    if (!of.empty()) page.say_more(of);
    ui::Sketch sketch;
    const Rect body{0.0F, 0.0F, rect.width, rect.height};
    sketch.add(ui::Box{body, 6.0F, ui::Fill::flat(strong ? ui::hex(0x454c52) : kKey)});
    sketch.add(ui::Frame{body, 6.0F, 2.0F, ui::hex(0x79848c)});
    page.sprite(rect, std::move(sketch), target);
    page.fixed_words({rect.x + 8.0F, rect.y + 0.5F * rect.height - 17.0F, rect.width - 16.0F, 36.0F},
                     {.text = name,
                      .type = design::kNote.bold_if(strong),
                      .colour = kPale,
                      .align = ui::Align::kCentre,
                      .language = page.english()});
}

Words plain(const std::string& text, const Page& page, const ui::Colour& colour = kPale) {
    return {.text = text, .type = design::kNote, .colour = colour, .language = page.english()};
}

void title_bar(Page& page) {
    page.box({0.0F, 0.0F, page.width(), 62.0F}, {kBar, kBar, kBar, kBar});
    Words title = plain("Staff panel", page);
    page.tell(title.text);
    title.type = title.type.bold_if(true);
    page.fixed_words({24.0F, 13.0F, 0.4F * page.width(), 40.0F}, title);
    Words name = plain(page.view().staff_title, page);
    name.align = ui::Align::kEnd;
    page.fixed_words({0.4F * page.width(), 13.0F, 0.6F * page.width() - 24.0F, 40.0F}, name);
}

// Asks for confirmation of an irreversible action; disables all other buttons.
void draw_question(Page& page) {
    const Staff& staff = page.view().state.staff;
    std::string question = "Quit the program?";
    std::string yes = "Quit";
    if (staff.question == StaffQuestion::kRestart) {
        question = "Restart the program?";
        yes = "Restart";
    } else if (staff.question == StaffQuestion::kDeletePot) {
        question = fmt::format("Delete {}? It cannot be brought back.", page.view().staff_pot);
        yes = "Delete";
    } else if (staff.question == StaffQuestion::kWithdrawCode) {
        question = fmt::format("Withdraw the code of {}? Phones find it no more.", page.view().staff_pot);
        yes = "Withdraw";
    }
    const float width = std::min(680.0F, page.width() - 48.0F);
    const Rect box{0.5F * (page.width() - width), 0.5F * page.height() - 130.0F, width, 230.0F};
    page.box(box, {kBar, kBar, kBar, kBar});
    Words words = plain(question, page);
    words.align = ui::Align::kCentre;
    page.tell(question);
    page.fixed_words({box.x + 24.0F, box.y + 28.0F, width - 48.0F, 76.0F}, words);
    const float half = 0.5F * (width - 72.0F);
    key(page, {box.x + 24.0F, box.bottom() - 96.0F, half, 72.0F}, Button::kStaffNo, 0, "No", true);
    key(page, {box.right() - 24.0F - half, box.bottom() - 96.0F, half, 72.0F}, Button::kStaffYes, 0, yes);
}

// Plots the frames of the last seconds as bars: the frame time and, in front, the GPU's time.
void draw_plot(Page& page, const Rect& rect, const FramePlot& plot) {
    constexpr float kMostMs = 50.0F;
    const Rect field{rect.x, rect.y + 34.0F, rect.width, rect.height - 34.0F};
    ui::Sketch sketch;
    sketch.add(ui::Box{{0.0F, 0.0F, field.width, field.height}, 0.0F, ui::Fill::flat(ui::hex(0x16191b))});
    const float step = field.width / static_cast<float>(std::max<std::size_t>(1, plot.frame_ms.size()));
    const auto bar = [&](std::size_t i, float ms, const ui::Colour& colour) {
        const float height = std::min(ms / kMostMs, 1.0F) * field.height;
        if (height <= 0.0F) return;
        sketch.add(ui::Box{{static_cast<float>(i) * step, field.height - height, 0.8F * step, height},
                           0.0F,
                           ui::Fill::flat(colour)});
    };
    constexpr float kSlowMs = 25.0F;
    for (std::size_t i = 0; i < plot.frame_ms.size(); ++i) {
        bar(i, plot.frame_ms[i], plot.frame_ms[i] > kSlowMs ? kWarn : ui::hex(0x6f8796));
        if (i < plot.device_ms.size()) bar(i, plot.device_ms[i], kOk);
    }
    constexpr float kRefreshMs = 1000.0F / 60.0F;
    for (const float ms : {kRefreshMs, 2.0F * kRefreshMs})
        sketch.add(ui::Box{{0.0F, field.height * (1.0F - ms / kMostMs), field.width, 1.5F},
                           0.0F,
                           ui::Fill::flat(kPale.with_alpha(0.55F))});
    page.sprite(field, std::move(sketch));
    page.fixed_words({rect.x, rect.y - 4.0F, rect.width, 36.0F},
                     plain("Frames of 10 s; green: drawing; lines: 17 and 33 ms", page, kDim));
}

// Draws the lines of the page from the first visible one. Returns the number drawn.
int draw_lines(Page& page, const Rect& rect) {
    const std::vector<StaffLine>& lines = page.view().staff_lines;
    const int first = std::min(page.view().state.staff.first_line, static_cast<int>(lines.size()));
    constexpr float kStep = 40.0F;
    constexpr float kKeyHeight = 50.0F;
    constexpr float kDeleteWidth = 120.0F;
    constexpr float kWithdrawWidth = 152.0F;
    constexpr float kGap = 12.0F;
    const float name_width = 0.28F * rect.width;
    const float status_width = 84.0F;
    float y = rect.y;
    int shown = 0;
    for (auto line = lines.begin() + first; line != lines.end(); ++line, ++shown) {
        const float delete_width = line->pot >= 0 ? kDeleteWidth + kGap : 0.0F;
        const float withdraw_width = line->code >= 0 ? kWithdrawWidth + kGap : 0.0F;
        const bool has_key = delete_width + withdraw_width > 0.0F;
        const float value_width = rect.width - name_width - kGap -
                                  (has_key                ? delete_width + withdraw_width
                                   : line->status.empty() ? 0.0F
                                                          : status_width);
        const Words name = plain(line->name, page, kDim);
        const Words value = plain(line->value, page);
        const float words_height = std::max(page.words_size(name, 1.0F, name_width).height,
                                            page.words_size(value, 1.0F, value_width).height);
        constexpr float kRoom = 10.0F;
        const float height = has_key ? std::max(kKeyHeight, words_height) + kRoom
                                     : std::max(kStep, words_height + kStep - value.type.line);
        if (y + height > rect.bottom() + 4.0F) break;
        page.tell(fmt::format("{}: {}", line->name, line->value));
        page.fixed_words({rect.x, y, name_width, words_height}, name);
        page.fixed_words({rect.x + name_width + kGap, y, value_width, words_height}, value);
        if (line->pot >= 0) {
            key(page, {rect.right() - kDeleteWidth, y - 8.0F, kDeleteWidth, kKeyHeight},
                Button::kStaffDeletePot, line->pot, "Delete", false, line->name);
        }
        if (line->code >= 0) {
            key(page, {rect.right() - delete_width - kWithdrawWidth, y - 8.0F, kWithdrawWidth, kKeyHeight},
                Button::kStaffWithdrawCode, line->code, "Withdraw", false, line->name);
        }
        if (!has_key && !line->status.empty()) {
            if (line->status != "ok") page.tell(line->status);
            Words status = plain(line->status, page,
                                 line->status == "ok"     ? kOk
                                 : line->status == "warn" ? kWarn
                                                          : kFault);
            status.type = status.type.bold_if(true);
            status.align = ui::Align::kEnd;
            page.fixed_words({rect.right() - status_width, y, status_width, 38.0F}, status);
        }
        y += height;
    }
    return shown;
}

struct Action {
    Button button;
    const char* name;
};
constexpr std::array kActions{Action{Button::kStaffForceTest, "Test the force"},
                              Action{Button::kStaffSoundTest, "Test the sound"},
                              Action{Button::kSoundLess, "Sound less"},
                              Action{Button::kSoundMore, "Sound more"},
                              Action{Button::kStaffLanguage, "Begin in "},  // followed by the language
                              Action{Button::kStaffRestart, "Restart the program"},
                              Action{Button::kStaffQuit, "Quit"},
                              Action{Button::kStaffClose, "Close the panel"}};

void draw_pin(Page& page) {
    const Staff& staff = page.view().state.staff;
    const int wait_s = page.view().seconds_left;
    page.covers();
    ground(page);
    const float middle = 0.5F * page.width();
    const int english = page.english();
    const std::string title = wait_s > 0        ? fmt::format("Not the PIN. Try again in {} s", wait_s)
                              : staff.was_wrong ? "That was not the PIN"
                                                : "Staff PIN";
    page.tell(staff.digits == 0 ? title : fmt::format("{}: {}", title, staff.digits));
    page.fixed_words({middle - 300.0F, 40.0F, 600.0F, 46.0F}, {.text = title,
                                                               .type = design::kBody,
                                                               .colour = kPale,
                                                               .align = ui::Align::kCentre,
                                                               .language = english});
    std::string dots;
    for (int i = 0; i < staff.digits; ++i)
        dots += "\u2022 ";
    page.fixed_words({middle - 300.0F, 92.0F, 600.0F, 60.0F}, {.text = dots.empty() ? "\u2013" : dots,
                                                               .type = {44.0F, 56.0F},
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
    const Staff& staff = view.state.staff;
    const float width = page.width();
    // The health page keeps the wheel drawn underneath, because it shows the frame times.
    if (staff.page != StaffPage::kHealth) page.covers();
    ground(page);
    title_bar(page);
    if (staff.question != StaffQuestion::kNone) {
        draw_question(page);
        return;
    }
    constexpr std::array<const char*, kStaffPageCount> kPages{"Health", "Visits", "Gallery", "Devices"};
    for (int i = 0; i < kStaffPageCount; ++i) {
        key(page, {24.0F + static_cast<float>(i) * 168.0F, 74.0F, 156.0F, 60.0F}, Button::kStaffPage, i,
            kPages[static_cast<std::size_t>(i)], i == static_cast<int>(staff.page));
        if (i == static_cast<int>(staff.page)) page.tell(kPages[static_cast<std::size_t>(i)]);
    }
    const bool tall = page.is_tall();
    const float side = page.is_square() ? 290.0F : 320.0F;
    const float actions_top = tall ? page.height() - 400.0F : 152.0F;
    Rect list{24.0F, 152.0F, tall ? width - 48.0F : width - side - 72.0F, 0.0F};
    list.height = (tall ? actions_top - 16.0F : page.height() - 12.0F) - list.y;
    if (!view.staff_notice.empty()) {
        constexpr float kNoticeHeight = 76.0F;
        list.height -= kNoticeHeight + 8.0F;
        page.tell(view.staff_notice);
        page.fixed_words({list.x, list.bottom() + 8.0F, list.width, kNoticeHeight},
                         plain(view.staff_notice, page, kWarn));
    }
    Rect lines = list;
    if (!view.staff_plot.frame_ms.empty()) {
        constexpr float kPlotHeight = 130.0F;
        draw_plot(page, {list.x, list.y, list.width, kPlotHeight}, view.staff_plot);
        lines = {list.x, list.y + kPlotHeight + 12.0F, list.width, list.height - kPlotHeight - 12.0F};
    }
    const int shown = draw_lines(page, lines);

    // Each action has a fixed place; a tall screen has two columns under the list.
    const auto place = [&](std::size_t i) {
        const float step = tall ? 76.0F : 70.0F;
        if (!tall) return Rect{width - 24.0F - side, actions_top + static_cast<float>(i) * step, side, 62.0F};
        return Rect{24.0F + (i % 2 == 0 ? 0.0F : 0.5F * width - 12.0F),
                    actions_top + static_cast<float>(i / 2) * step, 0.5F * width - 36.0F, 64.0F};
    };
    for (std::size_t i = 0; i < kActions.size(); ++i) {
        std::string name = kActions[i].name;
        if (kActions[i].button == Button::kStaffLanguage) {
            const auto language = static_cast<std::size_t>(view.state.house_language);
            name += (*view.languages)[std::min(language, view.languages->size() - 1)].shown("name");
        }
        key(page, place(i), kActions[i].button, 0, name, kActions[i].button == Button::kStaffClose);
    }
    const int first = std::min(staff.first_line, static_cast<int>(view.staff_lines.size()));
    const int behind = first + std::max(1, shown);
    const Rect turn = tall ? place(kActions.size()) : Rect{width - 24.0F - side, 74.0F, side, 60.0F};
    const float half = 0.5F * turn.width - 6.0F;
    const Rect back{turn.x, turn.y, half, turn.height};
    const Rect on{turn.right() - half, turn.y, half, turn.height};
    if (first > 0) key(page, back, Button::kStaffList, std::max(0, first - std::max(1, shown)), "Back");
    if (behind < static_cast<int>(view.staff_lines.size())) key(page, on, Button::kStaffList, behind, "More");
}

void count_wrong_pin(Turn& turn) {
    PinGuard& guard = turn.state.pin_guard;
    const Rules& rules = turn.rules;
    ++guard.wrong;
    if (guard.wrong < rules.pin_tries) return;
    constexpr int kMostDoublings = 30;
    const int doublings = std::min(guard.wrong - rules.pin_tries, kMostDoublings);
    const double wait_s = std::min(std::ldexp(rules.pin_wait_s, doublings), rules.pin_longest_wait_s);
    guard.opens_s = turn.now_s + wait_s;
}

void press_pin(Turn& turn, const event::Pressed& event) {
    Staff& staff = turn.state.staff;
    if (event.button == Button::kPinClear) staff = {};
    if (event.button != Button::kDigit || event.value < 0 || event.value > 9) return;
    if (pin_seconds_left(turn.state, turn.now_s) > 0) return;
    staff.typed = staff.typed * 10 + event.value;
    staff.was_wrong = false;
    if (++staff.digits < turn.rules.pin_digits) return;
    const bool right = staff.typed == turn.rules.pin;
    staff = {.was_wrong = !right};
    if (!right) return count_wrong_pin(turn);
    turn.state.pin_guard = {};
    turn.lay_over(Panel::kStaff);
}

// Handles the answer to draw_question().
void answer_question(Turn& turn, bool yes) {
    Staff& staff = turn.state.staff;
    const StaffQuestion question = std::exchange(staff.question, StaffQuestion::kNone);
    if (!yes) return;
    switch (question) {
        case StaffQuestion::kDeletePot:
            turn.add(effect::DeletePot{staff.pot});
            break;
        case StaffQuestion::kWithdrawCode:
            turn.add(effect::WithdrawCode{staff.pot});
            break;
        case StaffQuestion::kRestart:
            turn.add(effect::Restart{});
            break;
        case StaffQuestion::kQuit:
            turn.add(effect::Quit{});
            break;
        case StaffQuestion::kNone:
            break;
    }
}

void press_panel(Turn& turn, const event::Pressed& event) {
    Staff& staff = turn.state.staff;
    switch (event.button) {
        case Button::kStaffPage:
            if (event.value < 0 || event.value >= kStaffPageCount) break;
            staff.page = static_cast<StaffPage>(event.value);
            staff.first_line = 0;
            break;
        case Button::kStaffList:
            staff.first_line = std::max(0, event.value);
            break;
        case Button::kStaffForceTest:
            turn.add(effect::TestForce{});
            break;
        case Button::kStaffSoundTest:
            turn.add(effect::TestSound{});
            break;
        case Button::kSoundLess:
        case Button::kSoundMore:
            turn.change_volume(event.button == Button::kSoundMore ? 1 : -1);
            if (turn.state.house_volume == turn.state.comfort.volume) break;
            turn.state.house_volume = turn.state.comfort.volume;
            turn.add(effect::KeepHouse{});
            break;
        case Button::kStaffLanguage:
            turn.state.house_language = (turn.state.house_language + 1) % turn.rules.language_count;
            turn.state.comfort.language = turn.state.house_language;
            turn.add(effect::KeepHouse{});
            break;
        case Button::kStaffDeletePot:
        case Button::kStaffWithdrawCode:
            staff.question = event.button == Button::kStaffDeletePot ? StaffQuestion::kDeletePot
                                                                     : StaffQuestion::kWithdrawCode;
            staff.pot = event.value;
            break;
        case Button::kStaffRestart:
            staff.question = StaffQuestion::kRestart;
            break;
        case Button::kStaffQuit:
            staff.question = StaffQuestion::kQuit;
            break;
        default:
            break;
    }
}

void press_staff(Turn& turn, const event::Pressed& event) {
    turn.state.staff_used_s = turn.now_s;
    if (event.button == Button::kPinClose || event.button == Button::kStaffClose) {
        turn.leave_staff();
    } else if (turn.state.panel == Panel::kPin) {
        press_pin(turn, event);
    } else if (turn.state.staff.question == StaffQuestion::kNone) {
        press_panel(turn, event);
    } else if (event.button == Button::kStaffYes || event.button == Button::kStaffNo) {
        answer_question(turn, event.button == Button::kStaffYes);
    }
}

void pass_staff(Turn& turn) {
    if (turn.now_s - turn.state.staff_used_s >= turn.rules.staff_locks_s) turn.leave_staff();
}

}  // namespace

extern constinit const Overlay kPinOverlay{.panel = Panel::kPin,
                                           .name = "pin",
                                           .press = press_staff,
                                           .tick = pass_staff,
                                           .draw = draw_pin,
                                           .is_staffs = true};

extern constinit const Overlay kStaffOverlay{.panel = Panel::kStaff,
                                             .name = "staff",
                                             .press = press_staff,
                                             .tick = pass_staff,
                                             .draw = draw_staff,
                                             .is_staffs = true};

}  // namespace onggi::visit

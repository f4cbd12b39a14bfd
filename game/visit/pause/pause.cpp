// Interruptions of a visit: the idle countdown, the panel for language and comfort, the offer to continue an
// interrupted pot, the fault screen.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "game/visit/flow/turn.h"
#include "game/visit/jar/jar.h"

namespace onggi::visit {
namespace {

using ui::Rect;

void veil(Page& page, float top, float bottom) {
    page.down({0.0F, 0.0F, page.width(), 0.6F * page.height()}, design::kNight.with_alpha(top),
              design::kNight.with_alpha(0.5F * (top + bottom)));
    page.down({0.0F, 0.6F * page.height(), page.width(), 0.4F * page.height()},
              design::kNight.with_alpha(0.5F * (top + bottom)), design::kNight.with_alpha(bottom));
}

void draw_idle(Page& page) {
    const View& view = page.view();
    const float width = page.width();
    const float height = page.height();
    const bool tall = page.is_tall();
    veil(page, 0.90F, 0.95F);
    const vec2 centre(0.5F * width, tall ? 400.0F : 0.36F * height - 10.0F);
    const float fraction = std::clamp(static_cast<float>(view.seconds_left / view.countdown_s), 0.0F, 1.0F);
    ui::Sketch sketch;
    sketch.add(ui::Ellipse{{4.0F, 4.0F, 352.0F, 352.0F}, ui::Fill::flat(ui::hex(0x6f5a44))});
    sketch.add(ui::Ellipse{{7.0F, 7.0F, 346.0F, 346.0F}, ui::Fill::flat(ui::hex(0x2b2019))});
    sketch.add(ui::Shape{.path = spiral_path(1.0F), .stroke = ui::hex(0x4a3829), .stroke_width = 13.0F});
    if (fraction > 0.0F) {
        sketch.add(
            ui::Shape{.path = spiral_path(fraction), .stroke = ui::hex(0xc79a6c), .stroke_width = 13.0F});
        sketch.add(ui::Shape{.path = spiral_path(fraction),
                             .placing = {.at = {-2.0F, -3.0F}},
                             .stroke = ui::hex(0xe6c79d),
                             .stroke_width = 3.0F});
    }
    sketch.add(ui::Ellipse{{122.0F, 122.0F, 116.0F, 116.0F}, ui::Fill::flat(design::kNight)});
    page.sprite({centre.x - 180.0F, centre.y - 180.0F, 360.0F, 360.0F}, std::move(sketch));
    page.fixed_words({centre.x - 70.0F, centre.y - 46.0F, 140.0F, 92.0F},
                     {.text = page.digits(std::to_string(view.seconds_left)),
                      .type = design::bold(76.0F, 92.0F),
                      .colour = design::kWhiteSlip,
                      .align = ui::Align::kCentre});
    const float words_y = centre.y + 196.0F;
    const float button_y = height - (tall ? 330.0F : 120.0F);
    const float title = page.words(
        {60.0F, words_y, width - 120.0F, tall ? 150.0F : 72.0F},
        {.text = page.t("idle.title"), .type = design::serif(52.0F, 70.0F), .align = ui::Align::kCentre});
    page.words({60.0F, words_y + title + 2.0F, width - 120.0F, button_y - words_y - title - 8.0F},
               {.text = page.t("idle.line"),
                .type = design::kBody,
                .colour = design::kSlip3,
                .align = ui::Align::kCentre});
    const float button = std::min(280.0F, 0.5F * width - 60.0F);
    page.token(page.mirrored({0.5F * width - 14.0F - button, button_y, button, 84.0F}), Look::kOutline,
               Button::kFresh, page.named("idle.fresh"));
    page.token(page.mirrored({0.5F * width + 14.0F, button_y, button, 84.0F}), Look::kPrimary, Button::kStay,
               page.named("idle.stay"));
}

constexpr float kComfortGap = 24.0F;

// Where the tokens of the languages stand: up to four in a row, or one below the other on a tall screen, and
// two rows or columns of more. With low controls they are packed into the lower half.
struct LanguageGrid {
    int columns;
    float wide;
    float high;
    float between;
    float top;
};

LanguageGrid language_grid(const Page& page, int count) {
    constexpr int kFew = 4;
    const float height = page.height();
    const bool tall = page.is_tall();
    const bool low = page.is_low();
    const bool many = count > kFew;
    LanguageGrid grid{};
    if (tall) {
        grid.columns = low ? (many ? kFew : 2) : many ? 2 : 1;
    } else {
        grid.columns = many ? std::max(kFew, (count + 1) / 2) : count;
    }
    const int rows = (count + grid.columns - 1) / grid.columns;
    grid.wide = std::min(tall ? 480.0F : 330.0F,
                         (page.width() - 64.0F - kComfortGap * static_cast<float>(grid.columns - 1)) /
                             static_cast<float>(grid.columns));
    grid.between = low ? (many ? 14.0F : 12.0F) : 16.0F;
    grid.high = low ? (tall ? 84.0F : many ? 50.0F : 80.0F) : tall ? 110.0F : many ? 84.0F : 150.0F;
    // A tall screen has room below the title for the ring's name.
    const float room = height - 588.0F - static_cast<float>(rows) * (grid.high + grid.between);
    grid.top = low ? 0.5F * height + 2.0F : tall ? std::clamp(room, 140.0F, 232.0F) : 140.0F;
    return grid;
}

// Adds a token for each language. Returns the lower edge of the last.
float language_tokens(Page& page) {
    const View& view = page.view();
    const int count = static_cast<int>(view.languages->size());
    const LanguageGrid grid = language_grid(page, count);
    const float across = grid.wide + kComfortGap;
    const float left = 0.5F * (page.width() - across * static_cast<float>(grid.columns) + kComfortGap);
    float bottom = 0.0F;
    for (int i = 0; i < count; ++i) {
        const Rect rect{left + static_cast<float>(i % grid.columns) * across,
                        grid.top + static_cast<float>(i / grid.columns) * (grid.high + grid.between),
                        grid.wide, grid.high};
        page.language_token(rect, i, i == view.state.comfort.language);
        bottom = std::max(bottom, rect.bottom());
    }
    return bottom;
}

// Adds text size, volume, low controls, left hand and less motion in one row, or two on a tall screen.
void comfort_controls(Page& page, float y) {
    const Comfort& comfort = page.view().state.comfort;
    const float width = page.width();
    const bool tall = page.is_tall();
    const float gap = kComfortGap;
    const bool reversed = page.right_to_left();
    const auto stepper = [&](const Rect& place, Icon icon, int dots, int on, Button less, Button more,
                             const char* key) {
        const Rect rect = page.mirrored(place);
        page.stepper(rect, icon, {dots, on}, less, more, page.named(key), reversed);
        page.label({rect.x - 8.0F, rect.bottom() + 8.0F, rect.width + 16.0F, 66.0F}, page.t(key));
    };
    const auto toggle = [&](const Rect& place, Icon icon, bool on, Button button, const char* key) {
        const Rect rect = page.mirrored(place);
        page.toggle(rect, icon, on, button, page.named(key));
        page.label({rect.x - 10.0F, rect.bottom() + 8.0F, rect.width + 20.0F, 66.0F}, page.t(key));
    };
    const float stepper_width = std::min(238.0F, (width - 64.0F - 4.0F * gap) * 0.21F + 60.0F);
    const bool has_speech = page.view().offers_speech;
    const float toggles = has_speech ? 4.0F : 3.0F;
    const float toggle_width =
        tall ? std::min(180.0F, (width - 64.0F - (toggles - 1.0F) * gap) / toggles)
             : std::min(150.0F, (width - 64.0F - 2.0F * stepper_width - (toggles + 1.0F) * gap) / toggles);
    const float toggles_width = toggles * toggle_width + (toggles - 1.0F) * gap;
    if (tall) {
        const float two = 0.5F * width;
        stepper({two - 254.0F, y, 238.0F, 84.0F}, Icon::kText, kMostTextSize, comfort.text_size,
                Button::kTextLess, Button::kTextMore, "lang.text");
        stepper({two + 16.0F, y, 238.0F, 84.0F}, Icon::kSound, kMostVolume, comfort.volume,
                Button::kSoundLess, Button::kSoundMore, "lang.sound");
    } else {
        const float all = 2.0F * (stepper_width + gap) + toggles_width;
        const float x = 0.5F * (width - all);
        stepper({x, y, stepper_width, 84.0F}, Icon::kText, kMostTextSize, comfort.text_size,
                Button::kTextLess, Button::kTextMore, "lang.text");
        stepper({x + stepper_width + gap, y, stepper_width, 84.0F}, Icon::kSound, kMostVolume, comfort.volume,
                Button::kSoundLess, Button::kSoundMore, "lang.sound");
    }
    const float toggles_y = tall ? y + (page.is_low() ? 162.0F : 200.0F) : y;
    const float toggles_x =
        tall ? 0.5F * (width - toggles_width) : 0.5F * (width + 2.0F * (stepper_width + gap) - toggles_width);
    toggle({toggles_x, toggles_y, toggle_width, 84.0F}, Icon::kLow, comfort.reach, Button::kReach,
           "lang.reach");
    toggle({toggles_x + toggle_width + gap, toggles_y, toggle_width, 84.0F}, Icon::kHand, comfort.left_hand,
           Button::kLeftHand, "lang.left");
    toggle({toggles_x + 2.0F * (toggle_width + gap), toggles_y, toggle_width, 84.0F}, Icon::kStill,
           comfort.still, Button::kStill, "lang.still");
    if (!has_speech) return;
    toggle({toggles_x + 3.0F * (toggle_width + gap), toggles_y, toggle_width, 84.0F}, Icon::kSpeech,
           comfort.speech, Button::kSpeech, "lang.speech");
}

void draw_language(Page& page) {
    const float width = page.width();
    const bool tall = page.is_tall();
    const bool low = page.is_low();
    veil(page, 0.86F, 0.96F);
    // Two rows of languages and the other controls fill a lower half.
    const bool crowded = low && !tall && page.view().languages->size() > 4;
    // In all languages; where these are too many for a line, in the visitor's and in English.
    constexpr std::size_t kMostTitles = 4;
    const auto& languages = *page.view().languages;
    std::string title;
    const auto add_title = [&](const Language& language) {
        title += (title.empty() ? "" : " \u00b7 ") + language.shown("lang.title");
    };
    if (languages.size() <= kMostTitles) {
        std::for_each(languages.begin(), languages.end(), add_title);
    } else {
        add_title(page.language());
        const Language& english = page.language(page.english());
        if (english.code() != page.language().code()) add_title(english);
    }
    page.words({60.0F, 48.0F, width - 120.0F, 76.0F}, {.text = title,
                                                       .type = design::serif(40.0F, 56.0F),
                                                       .align = ui::Align::kCentre,
                                                       .language = languages.size() <= kMostTitles ? 0 : -1});
    const float bottom = language_tokens(page);
    comfort_controls(page, low ? bottom + (crowded ? 10.0F : 14.0F) : tall ? bottom + 70.0F : 352.0F);
    const float done_high = crowded ? 58.0F : low ? 80.0F : 84.0F;
    const float done_y = page.height() - (low ? done_high + 18.0F : tall ? 160.0F : 120.0F);
    page.token({0.5F * (width - 280.0F), done_y, 280.0F, done_high}, Look::kPrimary, Button::kComfortDone,
               page.named("lang.done"));
}

void draw_resume(Page& page) {
    const float width = page.width();
    const float height = page.height();
    const bool tall = page.is_tall();
    // The interrupted pot is drawn: the clay goes on the wheel only if the visitor accepts.
    page.museum({0.5F * width, 0.45F * height}, {0.5F * width, 0.55F * height}, 0.18F);
    const float shelf_y = tall ? 820.0F : height - 206.0F;
    page.shelf(shelf_y, 30.0F);
    const pot::Section left = page.view().left_over ? *page.view().left_over : pot::fresh_lump();
    const float scale = std::min(tall ? 2.2F : 1.6F, (shelf_y - (tall ? 410.0F : 230.0F)) / left.height_mm());
    page.keep_clear(page.pot(left, finish::wet_clay(), scale, {0.5F * width, shelf_y + 9.0F}));
    page.words(
        {60.0F, tall ? 250.0F : 70.0F, width - 120.0F, 160.0F},
        {.text = page.t("resume.title"), .type = design::serif(50.0F, 68.0F), .align = ui::Align::kCentre});
    const float y = height - (tall ? 330.0F : 150.0F);
    const float button = std::min(330.0F, 0.5F * width - 60.0F);
    page.token(page.mirrored({0.5F * width - 14.0F - button, y, button, 84.0F}), Look::kOutline,
               Button::kResumeFresh, page.named("ctl.again"), 0, tall ? std::optional<Icon>() : Icon::kAgain);
    page.token(page.mirrored({0.5F * width + 14.0F, y, button, 84.0F}), Look::kPrimary, Button::kResumeGo,
               page.named("resume.go"));
}

void draw_fault(Page& page) {
    const View& view = page.view();
    const float width = page.width();
    const float height = page.height();
    const bool tall = page.is_tall();
    const int count = static_cast<int>(view.languages->size());
    page.museum({0.5F * width, 0.42F * height}, {0.4F * width, 0.55F * height}, 0.16F);
    // All languages at once: in columns, or in rows on a tall screen; more than four in two of each.
    constexpr int kFew = 4;
    const bool many = count > kFew;
    const int columns = tall ? (many ? 2 : 1) : many ? (count + 1) / 2 : count;
    const float row_high = many ? 150.0F : tall ? 170.0F : 150.0F;
    const float shelf_y = tall ? 640.0F : height - (many ? 346.0F : 196.0F);
    page.shelf(shelf_y, 32.0F);
    if (!view.exhibits->empty()) {
        const Exhibit& resting = view.exhibits->back();
        const float scale =
            std::min(1.4F, (shelf_y - 120.0F) / (static_cast<float>(resting.height_mm) * 1.1F));
        page.keep_clear(
            page.pot(resting.shape, finish::glaze_at(0), scale, {0.5F * width, shelf_y + 12.0F}, 0.78F));
    }
    const float words_y = shelf_y + 46.0F;
    page.down({0.0F, shelf_y + 32.0F, width, 14.0F}, design::kNight.with_alpha(0.7F),
              design::kNight.with_alpha(0.93F));
    page.down({0.0F, words_y, width, height - words_y}, design::kNight.with_alpha(0.93F),
              design::kNight.with_alpha(0.97F));
    const float title_high = page.is_square() && many ? 74.0F : 50.0F;
    const float side = tall ? 32.0F : 24.0F;
    const float column = (width - 2.0F * side) / static_cast<float>(columns);
    for (int i = 0; i < count; ++i) {
        const Rect rect{side + column * static_cast<float>(i % columns) + 8.0F,
                        words_y + (tall ? 16.0F : 4.0F) + row_high * static_cast<float>(i / columns),
                        column - 16.0F, row_high};
        const float title = page.words({rect.x, rect.y, rect.width, title_high},
                                       {.text = page.language(i).shown("fault.title"),
                                        .type = design::serif(33.0F, 46.0F, 26.0F),
                                        .align = ui::Align::kCentre,
                                        .language = i});
        page.words({rect.x, rect.y + title + 2.0F, rect.width, 76.0F},
                   {.text = page.language(i).shown("fault.line"),
                    .type = design::kNote,
                    .colour = ui::hex(0xe6d8c0),
                    .align = ui::Align::kCentre,
                    .language = i});
    }
}

void press_resume(Turn& turn, const event::Pressed& event) {
    if (event.button == Button::kResumeGo) {
        turn.state.interrupted_session = false;
        const InterruptedPot pot = std::exchange(turn.state.interrupted_pot, {});
        turn.state.throwing = {.target = pot.target};
        turn.state.glaze = std::clamp(pot.glaze, 0, turn.rules.glaze_count - 1);
        turn.state.was_cut_off = pot.is_cut_off;
        turn.state.pace = {.progress_s = turn.now_s};
        turn.add(effect::Resume{});
        turn.show(Screen::kThrow);
        resume_jar(turn);
    } else if (event.button == Button::kResumeFresh) {
        turn.state.interrupted_session = false;
        turn.add(effect::DropInterrupted{});
        turn.show(Screen::kThrow);
        turn.put_on_clay(std::nullopt);
    }
}

void press_idle(Turn& turn, const event::Pressed& event) {
    turn.lay_over(Panel::kNone);
    if (event.button != Button::kFresh) return;
    if (turn.state.screen == Screen::kResume) return press_resume(turn, event::Pressed{Button::kResumeFresh});
    turn.show(Screen::kThrow);
    turn.put_on_clay(std::nullopt);
}

void pass_idle(Turn& turn) {
    if (turn.now_s - turn.state.panel_s >= turn.rules.countdown_s) turn.end_visit();
}

void press_language(Turn& turn, const event::Pressed& event) {
    Comfort& comfort = turn.state.comfort;
    switch (event.button) {
        case Button::kLanguage:
            if (event.value >= 0 && event.value < turn.rules.language_count) comfort.language = event.value;
            break;
        case Button::kTextLess:
        case Button::kTextMore:
            change(comfort.text_size, event.button == Button::kTextMore ? 1 : -1, kMostTextSize);
            break;
        case Button::kSoundLess:
        case Button::kSoundMore:
            turn.change_volume(event.button == Button::kSoundMore ? 1 : -1);
            break;
        case Button::kReach:
            comfort.reach = !comfort.reach;
            break;
        case Button::kLeftHand:
            comfort.left_hand = !comfort.left_hand;
            break;
        case Button::kStill:
            comfort.still = !comfort.still;
            break;
        case Button::kSpeech:
            if (turn.rules.offers_speech) comfort.speech = !comfort.speech;
            break;
        case Button::kComfortDone:
        case Button::kLanguages:
            turn.lay_over(Panel::kNone);
            // Choosing a language begins a visit.
            if (step_of(turn.state.screen).whose == Whose::kNobody) turn.begin_visit();
            break;
        default:
            break;
    }
}

void take_fault(Turn& turn, const Event& event) {
    if (std::holds_alternative<event::FaultOver>(event)) turn.end_visit();
}

std::string_view spoken_to_resume(const State& /*state*/) {
    return "resume.title";
}

std::string_view spoken_of_fault(const State& /*state*/) {
    return "fault.title";
}

}  // namespace

extern constinit const Step kResumeStep{.screen = Screen::kResume,
                                        .name = "resume",
                                        .press = press_resume,
                                        .draw = draw_resume,
                                        .spoken = spoken_to_resume,
                                        .shows_scene = true};

extern constinit const Step kFaultStep{.screen = Screen::kFault,
                                       .name = "fault",
                                       .whose = Whose::kStaff,
                                       .take = take_fault,
                                       .draw = draw_fault,
                                       .spoken = spoken_of_fault,
                                       .camera = Camera::kAttract};

extern constinit const Overlay kLanguageOverlay{.panel = Panel::kLanguage,
                                                .name = "language",
                                                .spoken = "lang.title",
                                                .press = press_language,
                                                .draw = draw_language};

extern constinit const Overlay kIdleOverlay{.panel = Panel::kIdle,
                                            .name = "idle",
                                            .spoken = "idle.title",
                                            .press = press_idle,
                                            .tick = pass_idle,
                                            .draw = draw_idle};

}  // namespace onggi::visit

// Attract: shows in turns the wheel throwing by itself, a museum's pot and the wall of the day. Any input
// begins a visit.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "game/visit/flow/turn.h"

namespace onggi::visit {
namespace {

using ui::Rect;

constexpr float kLit = 1.0F;
constexpr float kDimmed = 0.74F;  // brightness of all pots but the newest
constexpr float kMostGap = 90.0F;
constexpr float kLeastGap = 14.0F;
constexpr float kWallSide = 36.0F;

// The number of shelves, and of pots on each.
struct Boards {
    int count;
    int pots;
    float first_y;
    float step;
    float scale;  // u per mm; less if the pots do not fit
};

Boards boards_of(const Page& page, int pots) {
    const int a_row = page.by_shape(9, 7, 4);
    const int most = page.is_tall() ? 4 : 3;
    const int rows = std::clamp((pots + a_row - 1) / a_row, page.is_tall() ? 3 : 2, most);
    const float top = page.is_tall() ? 120.0F : 88.0F;
    const float bottom = page.height() - (page.is_tall() ? 200.0F : 156.0F);
    const float step = (bottom - top) / static_cast<float>(rows);
    return {rows, a_row, top + step, step, page.is_tall() ? 0.92F : 0.8F};
}

// One scale for all pots: the highest fits under the next board, and the widest row fits on its board.
float scale_of(const Page& page, const std::vector<ShelfPot>& pots, const Boards& boards) {
    float scale = boards.scale;
    for (std::size_t first = 0; first < pots.size(); first += static_cast<std::size_t>(boards.pots)) {
        const std::size_t end = std::min(pots.size(), first + static_cast<std::size_t>(boards.pots));
        float wide_mm = 0.0F;
        for (std::size_t i = first; i < end; ++i) {
            wide_mm += 2.0F * pots[i].shape.radius_mm();
            scale = std::min(scale, (boards.step - 52.0F) / std::max(1.0F, pots[i].shape.height_mm() * 1.1F));
        }
        const float room = page.width() - 2.0F * kWallSide - kLeastGap * static_cast<float>(end - first - 1);
        scale = std::min(scale, room / std::max(1.0F, wide_mm));
    }
    return scale;
}

void just_made(Page& page, vec2 foot, int language) {
    const Words words{.text = page.language(language).shown("wall.new"),
                      .type = design::bold(26.0F, 36.0F),
                      .colour = design::kSlip,
                      .align = ui::Align::kCentre,
                      .language = language};
    const float wide = page.words_width(words) + 44.0F;
    const float x = std::clamp(foot.x - 0.5F * wide, 12.0F, page.width() - wide - 12.0F);
    const Rect chip{x, foot.y + 24.0F, wide, 42.0F};
    ui::Sketch sketch;
    sketch.add(ui::Box{.rect = {0.0F, 0.0F, chip.width, chip.height},
                       .radius = 0.5F * chip.height,
                       .fill = ui::Fill::flat(design::kNight)});
    page.sprite(chip, std::move(sketch));
    page.fixed_words({chip.x, chip.y + 3.0F, chip.width, 36.0F}, words);
}

void draw_wall(Page& page) {
    const View& view = page.view();
    const std::vector<ShelfPot>& all = *view.wall;
    const Boards boards = boards_of(page, static_cast<int>(all.size()));
    // If there are too many, only the newest are shown.
    const auto room = static_cast<std::size_t>(boards.count * boards.pots);
    const std::vector<ShelfPot> pots(all.end() - static_cast<std::ptrdiff_t>(std::min(room, all.size())),
                                     all.end());
    const float width = page.width();
    const int language = view.attract_turn % static_cast<int>(view.languages->size());
    const bool rtl = page.language(language).right_to_left();
    const float scale = scale_of(page, pots, boards);
    // Places the pots in rows from the top, in the order in which they were made.
    std::vector<vec2> feet;
    for (std::size_t first = 0; first < pots.size(); first += static_cast<std::size_t>(boards.pots)) {
        const std::size_t end = std::min(pots.size(), first + static_cast<std::size_t>(boards.pots));
        float wide = 0.0F;
        for (std::size_t i = first; i < end; ++i)
            wide += 2.0F * pots[i].shape.radius_mm() * scale;
        const auto gaps = static_cast<float>(end - first + 1);
        const float gap = std::min(kMostGap, std::max(kLeastGap, (width - 2.0F * kWallSide - wide) / gaps));
        float x = 0.5F * (width - wide - gap * (gaps - 2.0F));
        const float y =
            boards.first_y + boards.step * static_cast<float>(first) / static_cast<float>(boards.pots);
        for (std::size_t i = first; i < end; ++i) {
            const float radius = pots[i].shape.radius_mm() * scale;
            feet.emplace_back(rtl ? width - x - radius : x + radius, y + 8.0F);
            x += 2.0F * radius + gap;
        }
    }
    const vec2 lit = view.wall_is_new ? feet.back() : vec2(0.5F * width, boards.first_y);
    page.museum({lit.x, lit.y - 60.0F}, view.wall_is_new ? vec2(190.0F, 190.0F) : vec2(0.5F * width, 300.0F),
                view.wall_is_new ? 0.4F : 0.22F);
    for (int board = 0; board < boards.count; ++board)
        page.shelf(boards.first_y + boards.step * static_cast<float>(board), 26.0F);
    for (std::size_t i = 0; i < pots.size(); ++i) {
        const finish::GlazeMaterial& glaze = finish::glaze_at(pots[i].glaze);
        if (view.wall_is_new && i + 1 == pots.size()) {
            page.keep_clear(page.turning_pot(pots[i].shape, glaze, scale, feet[i]));
        } else {
            page.keep_clear(
                page.pot(pots[i].shape, glaze, scale, feet[i], view.wall_is_new ? kDimmed : kLit));
        }
    }
    if (view.wall_is_new) just_made(page, lit, language);
    const bool tall = page.is_tall();
    const auto start = tall ? ui::Align::kCentre : ui::Align::kStart;
    page.words({kWallSide, 22.0F, width - 2.0F * kWallSide, 66.0F},
               {.text = page.language(language).shown("wall.title"),
                .type = design::serif(46.0F, 62.0F, 34.0F),
                .colour = design::kSlip,
                .align = start,
                .language = language});
    // A wide screen has room for both lines side by side.
    const bool stacked = page.shape() != Shape::kWide;
    const float y = page.height() - (stacked ? 112.0F : 74.0F);
    const float half = stacked ? width - 2.0F * kWallSide : 0.5F * width - kWallSide - 10.0F;
    const auto line = [&](const Rect& rect, std::string text, ui::Align align, bool bold) {
        page.words(rect, {.text = std::move(text),
                          .type = {28.0F, 38.0F, bold ? design::Face::kBold : design::Face::kPlain},
                          .colour = bold ? design::kSlip : design::kSlip2,
                          .align = align,
                          .language = language});
    };
    line({rtl && !stacked ? width - kWallSide - half : kWallSide, y, half, 42.0F},
         page.language(language).shown("wall.count", page.digits(std::to_string(pots.size()), language)),
         start, true);
    line({stacked || rtl ? kWallSide : width - kWallSide - half, stacked ? y + 42.0F : y, half, 42.0F},
         page.language(language).shown("wall.clear"), stacked ? start : ui::Align::kEnd, false);
}

constexpr ui::Colour kClear = design::kNight.with_alpha(0.0F);

Words begin_words(const Page& page, int place, float size, ui::Align align) {
    const bool turns_side = align == ui::Align::kStart && page.language(place).right_to_left();
    return {.text = page.language(place).shown("attract.touch"),
            .type = design::serif(size, std::round(1.34F * size), design::kLeastTextSize),
            .colour = design::kWhiteSlip,
            .align = turns_side ? ui::Align::kEnd : align,
            .language = place};
}

// The height of the highest line of "Touch to begin" at that size, or more than any room where one would
// break.
float begin_height(Page& page, float width, float size) {
    constexpr float kTooHigh = 1.0e6F;
    float height = 0.0F;
    for (int place = 0; place < static_cast<int>(page.view().languages->size()); ++place) {
        const ui::TextSize one =
            page.words_size(begin_words(page, place, size, ui::Align::kStart), 1.0F, width);
        height = std::max(height, one.too_wide || one.lines > 1 ? kTooHigh : one.height);
    }
    return height;
}

// "Touch to begin" in every language at equal size, in the configuration's order. The text is already large
// and ignores the previous visitor's text size. Many languages have smaller lines, `more` of the height
// above, and two columns where they are centred.
void begin_lines(Page& page, Rect rect, float size, ui::Align align, float gap, float more) {
    constexpr int kFew = 4;
    const int count = static_cast<int>(page.view().languages->size());
    const bool many = count > kFew;
    const int columns = many && align == ui::Align::kCentre ? 2 : 1;
    const int rows = (count + columns - 1) / columns;
    const float wide = rect.width / static_cast<float>(columns);
    if (many) {
        rect.y -= more;
        rect.height += more;
        gap = std::min(gap, 6.0F);
        const float most = rect.height / static_cast<float>(rows) - gap;
        while (size > design::kLeastTextSize && begin_height(page, wide - 16.0F, size) > most)
            size -= 1.0F;
    }
    float high = 0.0F;
    for (int place = 0; place < count; ++place) {
        const int column = place % columns;
        const float x = rect.x + wide * static_cast<float>(column);
        high = std::max(
            high, page.fixed_words({x, rect.y, wide, rect.height}, begin_words(page, place, size, align)));
        if (column + 1 < columns && place + 1 < count) continue;
        rect.y += high + gap;
        rect.height -= high + gap;
        high = 0.0F;
    }
    if (align != ui::Align::kStart) return;
    page.box({rect.x, rect.y + 10.0F, 56.0F, 5.0F},
             {design::kAmber, design::kAmber, design::kAmber, design::kAmber});
    rect.y += 40.0F;
    // In the first two languages; where the lines above have taken the room, in one at a time.
    const int first = count > kFew ? page.view().attract_turn % count : 0;
    const int last = count > kFew ? first + 1 : std::min(2, count);
    for (int place = first; place < last; ++place) {
        const float used = page.fixed_words(
            {rect.x, rect.y, rect.width, 84.0F},
            {.text = page.language(place).shown("attract.line"),
             .type = design::kLine,
             .colour = design::kSlip3,
             .align = page.language(place).right_to_left() ? ui::Align::kEnd : ui::Align::kStart,
             .language = place});
        rect.y += used;
    }
}

// Says that the wheel shows a demonstration, in one language at a time for lack of room.
void wheel_shows(Page& page, const Rect& rect) {
    const int place = page.view().attract_turn % static_cast<int>(page.view().languages->size());
    page.words(rect, {.text = page.language(place).shown("attract.auto"),
                      .type = design::kLine,
                      .colour = design::kSlip3,
                      .align = page.language(place).right_to_left() ? ui::Align::kEnd : ui::Align::kStart,
                      .language = place});
}

// Draws the exhibit's name, date, origin and height in one language.
void heritage_label(Page& page, const Exhibit& exhibit, const Rect& rect, int language) {
    const Language& tongue = page.language(language);
    const float name =
        page.fixed_words({rect.x, rect.y, rect.width, 38.0F}, {.text = tongue.shown(exhibit.name_key),
                                                               .type = design::bold(30.0F, 38.0F),
                                                               .align = ui::Align::kCentre,
                                                               .language = language});
    const std::string text =
        fmt::format("{}\n{} \u00b7 {}", tongue.shown(exhibit.museum_key), tongue.shown(exhibit.date_key),
                    page.whole_mm(exhibit.height_mm, language));
    page.fixed_words({rect.x, rect.y + name, rect.width, rect.height - name}, {.text = text,
                                                                               .type = design::kLabel,
                                                                               .colour = design::kSlip2,
                                                                               .align = ui::Align::kCentre,
                                                                               .language = language});
}

// Draws the labels of up to three languages side by side, of more in turns; in narrow pictures one language
// at a time.
void heritage_labels(Page& page, const Exhibit& exhibit, float y) {
    constexpr float kHigh = 104.0F;
    constexpr float kGap = 16.0F;
    const int count = static_cast<int>(page.view().languages->size());
    if (page.shape() != Shape::kWide) {
        heritage_label(page, exhibit, {40.0F, y, page.width() - 80.0F, kHigh},
                       page.view().attract_turn % count);
        return;
    }
    const int columns = std::min(count, 3);
    const float wide =
        (page.width() - 64.0F - kGap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
    for (int i = 0; i < columns; ++i) {
        const float x = 32.0F + (wide + kGap) * static_cast<float>(i);
        const int first = count > columns ? columns * page.view().attract_turn : 0;
        heritage_label(page, exhibit, {x, y, wide, kHigh}, (first + i) % count);
    }
}

void attract_heritage(Page& page, const Exhibit& exhibit) {
    const float width = page.width();
    const float height = page.height();
    const bool wide = page.shape() == Shape::kWide;
    const float shelf_y = page.by_shape(556.0F, 428.0F, 780.0F);
    const vec2 foot(wide ? 0.64F * width : 0.5F * width, shelf_y + 8.0F);
    page.museum({foot.x, 0.42F * height}, {0.46F * width, 0.62F * height}, 0.26F);
    page.shelf(shelf_y, 40.0F);
    page.down({0.0F, shelf_y + 40.0F, width, height - shelf_y - 40.0F}, ui::hex(0x1a120c), ui::hex(0x241a13));
    const float most = page.by_shape(460.0F, 340.0F, 560.0F);
    const float scale = std::min(1.58F, most / static_cast<float>(exhibit.height_mm));
    page.keep_clear(page.turning_pot(exhibit.shape, finish::glaze_at(exhibit.glaze), scale, foot));
    if (wide) {
        begin_lines(page, {64.0F, 80.0F, 330.0F, 440.0F}, 50.0F, ui::Align::kStart, 22.0F, -30.0F);
    } else {
        const bool tall = page.is_tall();
        begin_lines(page, {50.0F, tall ? 960.0F : 592.0F, width - 100.0F, tall ? 250.0F : 172.0F},
                    tall ? 50.0F : 40.0F, ui::Align::kCentre, 0.0F, 0.0F);
    }
    heritage_labels(page, exhibit, shelf_y + 48.0F);
}

void draw_attract(Page& page) {
    const View& view = page.view();
    if (view.wall) return draw_wall(page);
    const int exhibit = view.attract_exhibit;
    if (exhibit >= 0 && exhibit < static_cast<int>(view.exhibits->size())) {
        attract_heritage(page, (*view.exhibits)[static_cast<std::size_t>(exhibit)]);
        return;
    }
    const float width = page.width();
    const float height = page.height();
    const auto night = [](float alpha) { return design::kNight.with_alpha(alpha); };
    page.scene_ends();
    if (page.shape() == Shape::kWide) {
        page.across({0.0F, 0.0F, 0.24F * width, height}, night(0.94F), night(0.88F));
        page.across({0.24F * width, 0.0F, 0.18F * width, height}, night(0.88F), night(0.45F));
        page.across({0.42F * width, 0.0F, 0.14F * width, height}, night(0.45F), kClear);
        page.down({0.0F, 0.7F * height, width, 0.3F * height}, kClear, night(0.55F));
        begin_lines(page, {64.0F, 128.0F, 400.0F, 400.0F}, 50.0F, ui::Align::kStart, 26.0F, 20.0F);
        wheel_shows(page, {64.0F, height - 104.0F, 400.0F, 80.0F});
    } else if (page.is_tall()) {
        page.down({0.0F, 0.0F, width, 0.22F * height}, night(0.30F), kClear);
        page.down({0.0F, 0.56F * height, width, 0.17F * height}, kClear, night(0.94F));
        page.down({0.0F, 0.73F * height, width, 0.27F * height}, night(0.94F), night(1.0F));
        begin_lines(page, {50.0F, 980.0F, width - 100.0F, 270.0F}, 58.0F, ui::Align::kCentre, 8.0F, 0.0F);
    } else {
        page.down({0.0F, 0.0F, width, 0.25F * height}, night(0.25F), kClear);
        page.down({0.0F, 0.52F * height, width, 0.18F * height}, kClear, night(0.92F));
        page.down({0.0F, 0.70F * height, width, 0.30F * height}, night(0.92F), night(0.97F));
        begin_lines(page, {60.0F, 548.0F, width - 120.0F, 200.0F}, 48.0F, ui::Align::kCentre, 2.0F, 0.0F);
    }
}

void press_attract(Turn& turn, const event::Pressed& /*pressed*/) {
    turn.begin_visit();
}

void take_attract(Turn& turn, const Event& event) {
    const bool lives =
        std::holds_alternative<event::Input>(event) || std::holds_alternative<event::ClayTouched>(event);
    if (!lives) return;
    turn.begin_visit();
    turn.take(event);
}

// Attract never ends by itself, but an open language panel closes after a timeout.
void pass_attract(Turn& turn) {
    const State& state = turn.state;
    if (state.panel == Panel::kLanguage && turn.now_s - state.input_s >= turn.rules.idle_s) turn.end_visit();
}

std::string_view spoken_in_attract(const State& /*state*/) {
    return "attract.touch";
}

}  // namespace

extern constinit const Step kAttractStep{.screen = Screen::kAttract,
                                         .name = "attract",
                                         .whose = Whose::kNobody,
                                         .press = press_attract,
                                         .take = take_attract,
                                         .tick = pass_attract,
                                         .draw = draw_attract,
                                         .spoken = spoken_in_attract,
                                         .camera = Camera::kAttract,
                                         .shows_scene = true,
                                         .turns_wheel = true};

}  // namespace onggi::visit

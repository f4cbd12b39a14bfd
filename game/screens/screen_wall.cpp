// The wall of the day: pots whose makers have put them there, without a name, all at one scale.
#include <algorithm>
#include <string>
#include <vector>

#include "game/screens/screens.h"

namespace onggi::screens {
namespace {

using ui::Rect;

constexpr float kLit = 1.0F;
constexpr float kDimmed = 0.74F;  // the others, beside the newest
constexpr float kMostGap = 90.0F;
constexpr float kLeastGap = 14.0F;
constexpr float kSide = 36.0F;

// Shelves, and how many pots stand on one.
struct Boards {
    int count;
    int pots;
    float first_y;
    float step;
    float scale;  // u a mm, where the pots leave it so large
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

// One scale for all, so that the highest fits under the next board and the widest row on its own.
float scale_of(const Page& page, const std::vector<ShelfPot>& pots, const Boards& boards) {
    float scale = boards.scale;
    for (std::size_t first = 0; first < pots.size(); first += static_cast<std::size_t>(boards.pots)) {
        const std::size_t end = std::min(pots.size(), first + static_cast<std::size_t>(boards.pots));
        float wide_mm = 0.0F;
        for (std::size_t i = first; i < end; ++i) {
            wide_mm += 2.0F * pots[i].shape.radius_mm();
            scale = std::min(scale, (boards.step - 52.0F) / std::max(1.0F, pots[i].shape.height_mm() * 1.1F));
        }
        const float room = page.width() - 2.0F * kSide - kLeastGap * static_cast<float>(end - first - 1);
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

}  // namespace

void draw_wall(Page& page) {
    const View& view = page.view();
    const std::vector<ShelfPot>& all = *view.wall;
    const Boards boards = boards_of(page, static_cast<int>(all.size()));
    // The newest of them, where there is no room for all.
    const auto room = static_cast<std::size_t>(boards.count * boards.pots);
    const std::vector<ShelfPot> pots(all.end() - static_cast<std::ptrdiff_t>(std::min(room, all.size())),
                                     all.end());
    const float width = page.width();
    const int language = view.attract_turn % static_cast<int>(view.languages->size());
    const bool rtl = page.language(language).right_to_left();
    const float scale = scale_of(page, pots, boards);
    // Where each stands: rows from the top, by the time they were made.
    std::vector<vec2> feet;
    for (std::size_t first = 0; first < pots.size(); first += static_cast<std::size_t>(boards.pots)) {
        const std::size_t end = std::min(pots.size(), first + static_cast<std::size_t>(boards.pots));
        float wide = 0.0F;
        for (std::size_t i = first; i < end; ++i)
            wide += 2.0F * pots[i].shape.radius_mm() * scale;
        const auto gaps = static_cast<float>(end - first + 1);
        const float gap = std::min(kMostGap, std::max(kLeastGap, (width - 2.0F * kSide - wide) / gaps));
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
    page.words({kSide, 22.0F, width - 2.0F * kSide, 66.0F},
               {.text = page.language(language).shown("wall.title"),
                .type = design::serif(46.0F, 62.0F, 34.0F),
                .colour = design::kSlip,
                .align = start,
                .language = language});
    const float y = page.height() - (tall ? 112.0F : 74.0F);
    const float half = tall ? width - 2.0F * kSide : 0.5F * width - kSide - 10.0F;
    const auto line = [&](const Rect& rect, std::string text, ui::Align align, bool bold) {
        page.words(rect, {.text = std::move(text),
                          .type = {28.0F, 38.0F, bold ? design::Face::kBold : design::Face::kPlain, 20.0F},
                          .colour = bold ? design::kSlip : design::kSlip2,
                          .align = align,
                          .language = language});
    };
    line({rtl && !tall ? width - kSide - half : kSide, y, half, 42.0F},
         page.language(language).shown("wall.count", page.digits(std::to_string(pots.size()), language)),
         start, true);
    line({tall  ? kSide
          : rtl ? kSide
                : width - kSide - half,
          tall ? y + 42.0F : y, half, 42.0F},
         page.language(language).shown("wall.clear"), tall ? ui::Align::kCentre : ui::Align::kEnd, false);
}

}  // namespace onggi::screens

// What is told of a museum's pot on request: what it was for, how it was made, what to look for; each with
// how it is known, and where from.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "game/screens/screens.h"

namespace onggi::screens {
namespace {

using ui::Rect;

const Exhibit* exhibit_of(const View& view) {
    if (view.state.card == kiosk::kRelativesCard) return view.pot ? view.pot->relative.get() : nullptr;
    const auto place = static_cast<std::size_t>(view.state.card);
    return place < view.exhibits->size() ? &(*view.exhibits)[place] : nullptr;
}

std::string joined(std::initializer_list<std::string> parts) {
    std::string all;
    for (const std::string& part : parts)
        if (!part.empty()) all += (all.empty() ? "" : " \u00b7 ") + part;
    return all;
}

// From above: the pot's name, where and when, the three lines with their heads, the source.
std::vector<Words> lines_of(const Page& page, const Exhibit& exhibit) {
    constexpr std::array kHeads{"card.use", "card.making", "card.look"};
    constexpr std::array kKnownBy{"card.record", "card.kind", "card.general"};
    const auto language = static_cast<std::size_t>(page.view().state.comfort.language);
    std::vector<Words> lines{
        {.text = page.t(exhibit.name_key), .type = design::bold(32.0F, 38.0F), .colour = design::kInk},
        {.text =
             joined({page.t(exhibit.museum_key), page.t(exhibit.date_key), page.whole_mm(exhibit.height_mm)}),
         .colour = design::kInk2}};
    if (!exhibit.card || language >= exhibit.card->lines.size()) return lines;
    const ExhibitCard& card = *exhibit.card;
    for (std::size_t line = 0; line < kHeads.size(); ++line) {
        lines.push_back({.text = joined({page.t(kHeads[line]),
                                         page.t(kKnownBy[static_cast<std::size_t>(card.known_by[line])])}),
                         .type = design::bold(26.0F, 34.0F),
                         .colour = design::kRust});
        lines.push_back({.text = card.lines[language][line], .colour = design::kInk});
    }
    lines.push_back(
        {.text = joined({page.t("card.published", page.digits(std::to_string(card.published_points))),
                         page.t("card.drawn", page.digits(std::to_string(card.drawn_points)))}),
         .colour = design::kInk2});
    lines.push_back(
        {.text = page.t("card.source") + " \u2066" + card.source + "\u2069", .colour = design::kInk2});
    return lines;
}

}  // namespace

void draw_card_panel(Page& page) {
    const View& view = page.view();
    const float width = page.width();
    const float height = page.height();
    const bool tall = page.is_tall();
    // A squarer picture leaves the words more of its width.
    const float left = page.by_shape(0.34F, 0.26F, 1.0F);
    const float foot_y = height - 96.0F;
    const float shelf_y = tall ? 300.0F : foot_y - 50.0F;
    const Rect stage = page.mirrored({0.0F, 0.0F, left * width, shelf_y});
    page.museum({stage.centre().x, 0.5F * shelf_y}, {0.4F * width, 0.5F * height}, 0.28F);
    page.shelf(shelf_y, 30.0F);
    const Exhibit* const exhibit = exhibit_of(view);
    if (exhibit != nullptr) {
        const float scale = std::min({(stage.width - 48.0F) / (2.0F * exhibit->shape.radius_mm()),
                                      (shelf_y - 60.0F) / (exhibit->shape.height_mm() * 1.12F), 1.6F});
        page.keep_clear(page.turning_pot(exhibit->shape, finish::glaze_at(exhibit->glaze), scale,
                                         {stage.centre().x, shelf_y + 10.0F}));
        const Rect card =
            page.mirrored(tall ? Rect{24.0F, shelf_y + 44.0F, width - 48.0F, foot_y - shelf_y - 60.0F}
                               : Rect{left * width, 24.0F, (1.0F - left) * width - 32.0F, foot_y - 44.0F});
        page.card(card, design::kHanji, design::kHanji);
        const Rect inner{card.x + 22.0F, card.y + 14.0F, card.width - 44.0F, card.height - 24.0F};
        page.fitted_words(inner, page.fitted(lines_of(page, *exhibit), {inner.width, inner.height}, 2.0F));
    }
    page.back_token(page.mirrored({32.0F, foot_y + 8.0F, 190.0F, 70.0F}), kiosk::Button::kCardClose);
    if (view.state.card == kiosk::kRelativesCard) return;  // a pot is being looked at already
    page.token(page.mirrored({width - 332.0F, foot_y + 2.0F, 300.0F, 76.0F}), Look::kPrimary,
               kiosk::Button::kCardThrow, page.t("card.throw"));
}

}  // namespace onggi::screens

#include "game/screens/page/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "game/screens/page/legibility.h"

namespace onggi::screens {
namespace {

using ui::Colour;
using ui::Fill;
using ui::Rect;

}  // namespace

Page::Page(const View& view, ui::Painter& painter, PaintingStore& store)
    : view_(view),
      painter_(painter),
      store_(store),
      shape_(shape_of(view.width_px, view.height_px)) {
    composition_.px_per_u = px_per_u_of(view.width_px, view.height_px);
    composition_.mm_per_u = composition_.px_per_u / static_cast<float>(view.px_per_mm);
    composition_.bounds = {0.0F, 0.0F, static_cast<float>(view.width_px) / composition_.px_per_u,
                           static_cast<float>(view.height_px) / composition_.px_per_u};
    legible_scale_ = legible_scale(double{composition_.mm_per_u}, view.distance_mm);
    text_scale_ = (0.5F + 0.5F * static_cast<float>(view.state.comfort.text_size)) * legible_scale_;
}

float Page::smaller(float size, float base) const {
    constexpr float kStep = 0.96F;
    constexpr float kLargeText = 1.5F;  // where the middle of the three sizes begins
    const float least = base * legible_scale_;
    const float below = 0.9999F * size;
    if (size <= 1.0001F * least) return kStep * size;
    float next = least;
    while (next / kStep < below)
        next /= kStep;
    const float large = kLargeText * least;
    return large > next && large < below ? large : next;
}

const kiosk::Language& Page::language(int place) const {
    const auto& all = *view_.languages;
    const int wanted = place < 0 ? view_.state.comfort.language : place;
    return all[static_cast<std::size_t>(std::clamp(wanted, 0, static_cast<int>(all.size()) - 1))];
}

std::string Page::digits(std::string_view number, int place) const {
    if (!view_.own_digits || !language(place).is_arabic()) return std::string(number);
    return kiosk::in_arabic_digits(number);
}

std::string Page::measure(std::string_view number, std::string_view unit_key, int place) const {
    // Number and unit stay in this order and on one line, also inside Arabic: U+00A0 between them. The number
    // is fenced off as left-to-right (U+2066 to U+2069), so that "91 x 154" does not turn round.
    return "\u2066" + digits(number, place) + "\u2069\u00a0" + language(place).shown(unit_key);
}

std::string Page::whole_mm(double length_mm, int place) const {
    return measure(fmt::format("{:.0f}", length_mm), "unit.mm", place);
}

Rect Page::mirrored(const Rect& rect) const {
    if (!right_to_left()) return rect;
    return {width() - rect.x - rect.width, rect.y, rect.width, rect.height};
}

Rect Page::on_ledge(const Rect& rect) const {
    if (right_to_left() == view_.state.comfort.left_hand) return rect;
    return {width() - rect.x - rect.width, rect.y, rect.width, rect.height};
}

void Page::box(const Rect& rect, const std::array<Colour, 4>& corners) {
    Item item;
    item.rect = rect;
    item.corners = corners;
    composition_.items.push_back(std::move(item));
}

void Page::down(const Rect& rect, const Colour& top, const Colour& bottom) {
    box(rect, {top, top, bottom, bottom});
}

void Page::across(const Rect& rect, const Colour& left, const Colour& right) {
    box(rect, {left, right, right, left});
}

void Page::sprite(const Rect& rect, ui::Sketch sketch, int target) {
    sketch.size = {rect.width, rect.height};
    sketch.px_per_u = composition_.px_per_u;
    Item item;
    item.rect = rect;
    item.painting = store_.get(sketch, item.key);
    item.target = target;
    composition_.items.push_back(std::move(item));
}

void Page::picture(const Rect& rect, std::shared_ptr<const ui::Painting> painting, std::uint64_t key) {
    Item item;
    item.rect = rect;
    item.painting = std::move(painting);
    item.key = key;
    composition_.items.push_back(std::move(item));
}

ui::TextStyle Page::style(const Words& words) const {
    const kiosk::Language& tongue = language(words.language);
    const bool arabic = tongue.is_arabic();
    ui::TextStyle style;
    const design::Face face = words.type.face;
    style.family = face == design::Face::kSerif ? (arabic ? design::kTitleFamilyArabic : design::kTitleFamily)
                                                : (arabic ? design::kUiFamilyArabic : design::kUiFamily);
    style.bold = face != design::Face::kPlain;
    style.size = words.type.size;
    style.line_height = words.type.line;
    style.colour = words.colour;
    style.align = words.align;
    style.right_to_left = tongue.right_to_left();
    style.language = tongue.code();
    return style;
}

float Page::words_width(const Words& words) {
    return painter_.measure({.words = words.text, .style = style(words)}).width;
}

ui::TextSize Page::words_size(Words words, float scale, float width) {
    words.type = words.type.times(scale);
    return painter_.measure({.words = words.text, .style = style(words), .width = width});
}

float Page::words(const Rect& rect, const Words& wanted, bool on_pot) {
    Words words = wanted;
    design::Type& type = words.type;
    const float line_ratio = type.line / type.size;
    type.size *= text_scale_;
    ui::Text text;
    ui::TextSize size;
    // As large as asked for, or as large as fits.
    for (;; type.size = std::max(type.least_size, smaller(type.size, wanted.type.size))) {
        type.line = type.size * line_ratio;
        text = {.words = words.text, .style = style(words), .width = rect.width};
        size = painter_.measure(text);
        if ((!size.too_wide && size.height <= rect.height + 0.5F) || type.size <= type.least_size) break;
    }
    const bool rtl = text.style.right_to_left;
    const bool from_right = (words.align == ui::Align::kStart) == rtl;
    float x = from_right ? rect.right() - size.width : rect.x;
    if (words.align == ui::Align::kCentre) x = rect.x + 0.5F * (rect.width - size.width);
    constexpr float kLean = 6.0F;  // letters lean out of their boxes
    const float width = size.width + 2.0F;
    ui::Sketch sketch;
    text.width = width;
    sketch.add(ui::Writing{.at = {kLean, kLean}, .text = text, .box_width = width});
    sprite({x - kLean, rect.y - kLean, width + 2.0F * kLean, size.height + 2.0F * kLean}, std::move(sketch));
    composition_.items.back().is_words = true;
    const float air = 0.5F * (type.line - type.size);
    composition_.writings.push_back({.words = words.text,
                                     .rect = {x, rect.y + air, size.width, size.height - 2.0F * air},
                                     .size = type.size,
                                     .colour = words.colour,
                                     .within = rect,
                                     .unknown_glyphs = size.unknown_glyphs,
                                     .too_wide = size.too_wide,
                                     .on_pot = on_pot});
    return size.height;
}

float Page::fixed_words(const Rect& rect, const Words& wanted) {
    const float scale = std::exchange(text_scale_, 1.0F);
    const float height = words(rect, wanted, true);
    text_scale_ = scale;
    return height;
}

FittedLines Page::fitted(std::vector<Words> lines, vec2 room, float between) {
    FittedLines made;
    float scale = text_scale_;
    for (;; scale = std::max(1.0F, smaller(scale, 1.0F))) {
        made = {};
        bool is_too_wide = false;
        for (const Words& words : lines) {
            const ui::TextSize size = words_size(words, scale, room.x);
            made.heights.push_back(size.height + between);
            made.height += made.heights.back();
            is_too_wide = is_too_wide || size.too_wide;
        }
        if (scale <= 1.0F || (made.height <= room.y && !is_too_wide)) break;
    }
    for (Words& words : lines)
        words.type = words.type.times(scale);
    made.lines = std::move(lines);
    return made;
}

void Page::fitted_words(const Rect& rect, const FittedLines& fitted) {
    float y = rect.y;
    for (std::size_t i = 0; i < fitted.lines.size(); y += fitted.heights[i++])
        fixed_words({rect.x, y, rect.width, rect.bottom() - y + 2.0F}, fitted.lines[i]);
}

Item Page::loose_words(const Words& words, float least_width, bool on_chip) {
    const ui::Text text{.words = words.text, .style = style(words)};
    const ui::TextSize size = painter_.measure(text);
    const float air = on_chip ? 12.0F : 2.0F;
    const float width = std::max(size.width, least_width) + 2.0F * air;
    ui::Sketch sketch;
    sketch.size = {width, size.height + (on_chip ? 4.0F : 0.0F)};
    sketch.px_per_u = composition_.px_per_u;
    if (on_chip) {
        sketch.add(ui::Box{{0.0F, 0.0F, sketch.size.x, sketch.size.y},
                           12.0F,
                           ui::Fill::flat(design::kNight.with_alpha(0.86F))});
    }
    sketch.add(
        ui::Writing{.at = {air, on_chip ? 2.0F : 0.0F}, .text = text, .box_width = width - 2.0F * air});
    Item item;
    item.rect = {0.0F, 0.0F, sketch.size.x, sketch.size.y};
    item.painting = store_.get(sketch, item.key);
    return item;
}

int Page::english() const {
    const auto& all = *view_.languages;
    for (std::size_t place = 0; place < all.size(); ++place) {
        if (all[place].code() == "en") return static_cast<int>(place);
    }
    return 0;
}

int Page::add_target(const Rect& rect, kiosk::Button button, int value, std::string name, bool repeats) {
    composition_.targets.push_back(
        {.button = button, .value = value, .rect = rect, .name = std::move(name), .repeats = repeats});
    return static_cast<int>(composition_.targets.size()) - 1;
}

// Above the ring, or below it where there is no room or words stand.
void Page::name_ring(const Rect& ring, const std::string& name) {
    constexpr float kEdge = 24.0F;
    const float high = 20.0F + 32.0F * text_scale_;
    const float most = width() - 2.0F * kEdge;
    const float wide =
        std::min(most, words_width({.text = name, .type = design::kLabel}) * text_scale_ * 1.02F + 44.0F);
    const float x = std::clamp(ring.centre().x - 0.5F * wide, kEdge, width() - kEdge - wide);
    const float above = ring.y - 8.0F - high;
    const float below = std::min(ring.bottom() + 8.0F, height() - high - 8.0F);
    const auto hides_words = [&](float at) {
        return std::any_of(composition_.writings.begin(), composition_.writings.end(),
                           [&](const Writing& text) {
                               const Rect common = overlap(Rect{x, at, wide, high}, text.rect);
                               return common.width > 2.0F && common.height > 3.0F;
                           });
    };
    const bool goes_below = above < 8.0F || (hides_words(above) && !hides_words(below));
    const float y = goes_below ? below : above;
    ui::Sketch sketch;
    sketch.add(ui::Box{{0.0F, 0.0F, wide, high}, 24.0F, Fill::flat(design::kNight.with_alpha(0.94F))});
    sprite({x, y, wide, high}, std::move(sketch));
    words({x + 18.0F, y + 8.0F, wide - 36.0F, high - 12.0F},
          {.text = name, .type = design::kLabel, .align = ui::Align::kCentre}, true);
    composition_.writings.back().over = true;
}

Composition Page::take() {
    // The ring on what keyboard or switch would press now, and its name beside it.
    const int focus = view_.focus;
    if (focus >= 0 && focus < static_cast<int>(composition_.targets.size())) {
        const Target target = composition_.targets[static_cast<std::size_t>(focus)];
        ui::Sketch sketch;
        const Rect ring = target.rect.grown(14.0F);
        const Rect body{0.0F, 0.0F, ring.width, ring.height};
        const float radius = std::min(48.0F, 0.5F * ring.height);
        sketch.add(ui::Frame{body, radius, 4.0F, design::kNight});
        sketch.add(ui::Frame{body.grown(-4.0F), radius - 4.0F, 5.0F, ui::hex(0xfff7e6)});
        sprite(ring, std::move(sketch));
        name_ring(ring, target.name);
    }
    return std::move(composition_);
}

}  // namespace onggi::screens

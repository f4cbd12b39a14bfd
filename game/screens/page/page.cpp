#include "game/screens/page/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "engine/core/hash.h"
#include "game/screens/page/fonts.h"
#include "game/screens/page/legibility.h"

namespace onggi::screens {
namespace {

using ui::Colour;
using ui::Fill;
using ui::Rect;

constexpr float kShadowReach = 14.0F;  // of a token, u

constexpr float kMuseumElevationRad = 0.12F;

// Keep an unused painting for this number of compositions, so that opening and closing a panel repaints
// nothing.
constexpr int kPatience = 24;
// Limit of the memory of unused paintings, newest first: enough for a screen with a turning pot, not for a
// whole visit.
constexpr std::size_t kMostUnusedBytes = std::size_t{6} << 20U;

std::size_t bytes_of(const ui::Painting& painting) {
    return painting.rgba.size();
}

std::size_t bytes_of(const PotPicture& picture) {
    return picture.painting.rgba.size();
}

std::size_t bytes_of(const TurningPot& pot) {
    return pot.bytes();
}

const std::shared_ptr<const ui::Painting>& nothing() {
    static const auto empty = std::make_shared<const ui::Painting>();
    return empty;
}

std::uint64_t key_of(const pot::Section& shape, const finish::GlazeMaterial& glaze, float px_per_mm,
                     float elevation_rad) {
    StateHash hash;
    hash.add_word(shape.hash());
    for (const char letter : glaze.id)
        hash.add_word(static_cast<std::uint64_t>(letter));
    hash.add(double{px_per_mm});
    hash.add(double{elevation_rad});
    return hash.value();
}

// "Water, 3 of 5".
std::string setting_words(const kiosk::Language& language, const Name& name, const Steps& steps) {
    const std::string& words = language.spoken(name.key);
    const std::string on = std::to_string(steps.on);
    if (words.find("{n}") != std::string::npos) return kiosk::filled_in(words, on);
    return words + ", " + kiosk::filled_in(language.spoken("ear.place"), on, std::to_string(steps.most));
}

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
    constexpr float kLargeText = 1.5F;  // from this scale on, the middle one of three sizes
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
    return language(place).number(number, view_.own_digits);
}

std::string Page::measure(std::string_view number, std::string_view unit_key, int place) const {
    // U+00A0 keeps number and unit on one line and in this order, also inside Arabic. The number is isolated
    // as left-to-right (U+2066 to U+2069), so that "91 x 154" is not reversed.
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
    const Families& families = families_of(tongue);
    ui::TextStyle style;
    const design::Face face = words.type.face;
    style.family = face == design::Face::kSerif ? families.title : families.ui;
    style.bold = face == design::Face::kBold || (face == design::Face::kSerif && families.has_bold_titles);
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
    // Tries the wanted size, then smaller ones until one fits.
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
    constexpr float kLean = 6.0F;  // letters overhang their boxes
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

int Page::add_target(const Rect& rect, kiosk::Button button, int value, const Name& name, bool repeats) {
    composition_.targets.push_back({.button = button,
                                    .value = value,
                                    .rect = rect,
                                    .name = name.shown,
                                    .key = name.key,
                                    .spoken = name.key.empty() ? name.shown : language().spoken(name.key),
                                    .repeats = repeats});
    return static_cast<int>(composition_.targets.size()) - 1;
}

void Page::say_chosen() {
    composition_.targets.back().spoken += ", " + language().spoken("ear.chosen");
}

// Places the name above the ring, or below it if there is no room or other words are there.
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
    // Draws the focus ring of keyboard or switch on its target, with the target's name.
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

// The parts of the design: tokens, steppers, cards, niches.

// A glazed pebble with a foot of bare clay; when pressed, it sinks until the foot is hidden.
void Page::token_body(ui::Sketch& sketch, const Rect& rect, Look look, bool pressed) const {
    const float radius = std::min(40.0F, 0.5F * rect.height);
    if (look == Look::kOutline) {
        sketch.add(ui::Box{rect, radius, Fill::flat(design::kNight.with_alpha(pressed ? 0.95F : 0.82F))});
        sketch.add(ui::Frame{rect, radius, 2.5F, design::kTokenEdge});
        return;
    }
    const Colour dark = ui::hex(0x0a0603, 0.45F);
    if (pressed) {
        sketch.add(ui::Shadow{rect.moved({0.0F, 1.0F}), radius, 4.0F, dark});
    } else {
        sketch.add(ui::Shadow{rect.moved({0.0F, 5.0F}), radius, 12.0F, dark});
        sketch.add(ui::Box{rect, radius, Fill::flat(design::kBareClay)});
    }
    const Rect glaze{rect.x, rect.y, rect.width, rect.height - (pressed ? 0.0F : 6.0F)};
    sketch.add(ui::Box{glaze, radius, Fill::flat(ui::hex(0xfffdf8))});
    const Rect face{glaze.x, glaze.y + 2.0F, glaze.width, glaze.height - 2.0F};
    const bool primary = look == Look::kPrimary;
    sketch.add(ui::Box{face, radius,
                       primary ? Fill::down(design::kCeladonHi, design::kCeladonLo)
                               : Fill::down(design::kTokenHi, design::kTokenLo)});
}

int Page::token(const Rect& rect, Look look, kiosk::Button button, const Name& name, int value,
                std::optional<Icon> icon, bool with_words, bool repeats) {
    const int target = add_target(rect, button, value, name, repeats);
    const Rect reach = rect.grown(kShadowReach);
    const Rect inside{kShadowReach, kShadowReach, rect.width, rect.height};
    Item item;
    for (const bool pressed : {false, true}) {
        ui::Sketch sketch;
        sketch.size = {reach.width, reach.height};
        sketch.px_per_u = composition_.px_per_u;
        const Rect body = pressed ? inside.moved({0.0F, 4.0F}) : inside;
        token_body(sketch, body, look, pressed);
        if (icon && !with_words) {
            const float side = 0.6F * rect.height;
            const Colour stroke = look == Look::kOutline ? design::kSlip : design::kInk;
            add_icon(sketch, *icon, body.centre() - vec2(0.5F * side, 0.5F * side + 2.0F), side, stroke);
        }
        std::uint64_t key = 0;
        auto painting = store_.get(sketch, key);
        (pressed ? item.pressed_painting : item.painting) = std::move(painting);
        (pressed ? item.pressed_key : item.key) = key;
    }
    item.rect = reach;
    item.target = target;
    composition_.items.push_back(std::move(item));
    if (!with_words) return target;

    const Colour ink = look == Look::kOutline ? design::kSlip : design::kInk;
    const float lift = look == Look::kOutline ? 0.0F : 3.0F;
    const float icon_side = icon ? (rect.height > 75.0F ? 44.0F : 36.0F) : 0.0F;
    const bool is_narrow = icon && rect.width < 200.0F;
    const float gap = is_narrow ? 6.0F : icon ? 12.0F : 0.0F;
    Words words{.text = name.shown, .type = design::bold(30.0F, 38.0F), .colour = ink};
    const float room = rect.width - (is_narrow ? 20.0F : 36.0F) - icon_side - gap;
    // One line, as large as fits between the rounded corners.
    float& size = words.type.size;
    const float base = size;
    size *= text_scale_;
    while (size > design::kLeastTextSize && (words_width(words) > room || size * 1.25F > rect.height - 8.0F))
        size = std::max(design::kLeastTextSize, smaller(size, base));
    words.type.line = size * 1.26F;
    const float wide = words_width(words);
    float x = rect.x + 0.5F * (rect.width - wide - icon_side - gap);
    const float middle = rect.y + 0.5F * rect.height - lift;
    const bool icon_last = right_to_left();
    const std::size_t first = composition_.items.size();
    if (icon) {
        ui::Sketch sketch;
        add_icon(sketch, *icon, {0.0F, 0.0F}, icon_side, ink);
        const float icon_x = icon_last ? x + wide + gap : x;
        sprite({icon_x, middle - 0.5F * icon_side, icon_side, icon_side}, std::move(sketch), target);
        if (!icon_last) x += icon_side + gap;
    }
    const float scale = std::exchange(text_scale_, 1.0F);  // the size is already scaled
    words.align = right_to_left() ? ui::Align::kEnd : ui::Align::kStart;
    const float box_width = std::max(wide, std::min(room, wide + 1.0F)) + 1.0F;
    this->words({x, middle - 0.5F * words.type.line, box_width, words.type.line + 1.0F}, words);
    text_scale_ = scale;
    for (std::size_t i = first; i < composition_.items.size(); ++i)
        composition_.items[i].target = target;
    composition_.writings.back().within = rect;
    return target;
}

void Page::dotted(std::span<const vec2> points) {
    if (points.size() < 2) return;
    vec2 low = points.front();
    vec2 high = low;
    for (const vec2& point : points) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    constexpr float kMargin = 6.0F;
    std::string path;
    for (const vec2& point : points) {
        const vec2 at = point - low + kMargin;
        path += fmt::format("{}{:.1f} {:.1f} ", path.empty() ? 'M' : 'L', at.x, at.y);
    }
    constexpr float kPitch = 13.0F;
    ui::Sketch sketch;
    sketch.add(ui::Shape{
        .path = path, .stroke = design::kNight.with_alpha(0.55F), .stroke_width = 7.0F, .dash = kPitch});
    sketch.add(ui::Shape{.path = path, .stroke = design::kOutline, .stroke_width = 4.4F, .dash = kPitch});
    const vec2 size = high - low + 2.0F * kMargin;
    sprite({low.x - kMargin, low.y - kMargin, size.x, size.y}, std::move(sketch));
}

void Page::stepper(const Rect& rect, Icon icon, const Steps& steps, kiosk::Button less, kiosk::Button more,
                   const Name& name, bool reversed) {
    const int dots = steps.most;
    const float end = rect.height > 75.0F ? 72.0F : 50.0F;
    const float picture = rect.height > 75.0F ? 44.0F : 38.0F;
    ui::Sketch sketch;
    const Rect body{kShadowReach, kShadowReach, rect.width, rect.height};
    token_body(sketch, body, Look::kToken, false);
    const float middle = body.centre().y - 3.0F;
    const Colour line = ui::hex(0x5c4a39, 0.22F);
    for (const float x : {body.x + end, body.right() - end - 2.0F})
        sketch.add(ui::Box{{x, body.y + 3.0F, 2.0F, body.height - 10.0F}, 0.0F, Fill::flat(line)});
    const float sign = rect.height > 75.0F ? 30.0F : 26.0F;
    const vec2 left(body.x + 0.5F * (end - sign), middle - 0.5F * sign);
    const vec2 right(body.right() - 0.5F * (end + sign), middle - 0.5F * sign);
    add_icon(sketch, Icon::kMinus, reversed ? right : left, sign, design::kInk);
    add_icon(sketch, Icon::kPlus, reversed ? left : right, sign, design::kInk);
    add_icon(sketch, icon, {body.centre().x - 0.5F * picture, body.y + 3.0F}, picture, design::kInk);
    const float dot_step = std::min(12.0F, (rect.width - 2.0F * end - 13.0F) / static_cast<float>(dots - 1));
    for (int i = 0; i < dots; ++i) {
        const int place = reversed ? dots - 1 - i : i;
        const float x =
            body.centre().x + (static_cast<float>(place) - 0.5F * static_cast<float>(dots - 1)) * dot_step;
        const Rect dot{x - 4.5F, body.bottom() - (rect.height > 75.0F ? 24.0F : 19.0F), 9.0F, 9.0F};
        sketch.add(ui::Ellipse{dot, Fill::flat(design::kDot)});
        if (i >= steps.on) sketch.add(ui::Ellipse{dot.grown(-2.0F), Fill::flat(ui::hex(0xf3e9d8))});
    }
    sprite(rect.grown(kShadowReach), std::move(sketch));
    if (less == kiosk::Button::kNone) {
        composition_.items.back().alpha = design::kRestingAlpha;
        return;
    }
    const Rect first{rect.x, rect.y, end, rect.height};
    const Rect last{rect.right() - end, rect.y, end, rect.height};
    const std::string now = setting_words(language(), name, steps) + ". ";
    add_target(reversed ? last : first, less, 0, {name.shown + " \xe2\x88\x92"}, true);  // U+2212
    composition_.targets.back().spoken = now + language().spoken("ear.less");
    add_target(reversed ? first : last, more, 0, {name.shown + " +"}, true);
    composition_.targets.back().spoken = now + language().spoken("ear.more");
}

void Page::label(const Rect& rect, const std::string& text, const Colour& colour) {
    words(rect, {.text = text, .type = design::kLabel, .colour = colour, .align = ui::Align::kCentre});
}

void Page::card(const Rect& rect, const Colour& top, const Colour& bottom, int target) {
    constexpr float kReach = 28.0F;
    ui::Sketch sketch;
    const Rect body{kReach, kReach, rect.width, rect.height};
    sketch.add(ui::Shadow{body.moved({0.0F, 8.0F}), 11.0F, 26.0F, ui::hex(0x080402, 0.45F)});
    sketch.add(ui::Box{body, 11.0F, Fill::down(top, bottom)});
    sketch.add(ui::Frame{body, 11.0F, 1.0F, ui::hex(0xffffff, 0.5F)});
    sprite(rect.grown(kReach), std::move(sketch), target);
}

int Page::card_target(const Rect& rect, bool celadon, kiosk::Button button, int value, const Name& name) {
    const int target = add_target(rect, button, value, name, false);
    card(rect, celadon ? design::kCeladonHi : design::kHanji, celadon ? ui::hex(0xb3ccac) : design::kHanji,
         target);
    return target;
}

int Page::card_niche(const Rect& rect, bool chosen, kiosk::Button button, int value, const Name& name) {
    const int target = add_target(rect, button, value, name, false);
    if (chosen) {
        say_chosen();
        card(rect, design::kHanji, design::kHanji, target);
        return target;
    }
    ui::Sketch sketch;
    const Rect body{0.0F, 0.0F, rect.width, rect.height};
    sketch.add(ui::Box{body, 11.0F, Fill::flat(design::kNiche.with_alpha(0.96F))});
    sketch.add(ui::Frame{body, 11.0F, 2.0F, design::kNicheEdge});
    sprite(rect, std::move(sketch), target);
    return target;
}

Rect Page::languages_token(const Rect& low) {
    const Rect rect = mirrored(is_low() ? low : Rect{width() - 32.0F - 150.0F, 28.0F, 150.0F, 60.0F});
    const int target = add_target(rect, kiosk::Button::kLanguages, 0, named("lang.title"), false);
    ui::Sketch sketch;
    const Rect body{0.0F, 0.0F, rect.width, rect.height};
    token_body(sketch, body, Look::kOutline, false);
    // The letters of the first languages that differ in them: more than three do not fit.
    constexpr std::size_t kMostLetters = 3;
    constexpr float kGap = 16.0F;
    std::vector<Words> letters;
    float x = 0.5F * (rect.width + kGap);
    for (int place = 0; place < static_cast<int>(view_.languages->size()); ++place) {
        Words letter{.text = language(place).shown("lang.letter"),
                     .type = design::bold(29.0F, 36.0F),
                     .language = place};
        const bool is_there = std::any_of(letters.begin(), letters.end(),
                                          [&](const Words& other) { return other.text == letter.text; });
        if (is_there || letters.size() == kMostLetters) continue;
        x -= 0.5F * (words_width(letter) + kGap);
        letters.push_back(std::move(letter));
    }
    for (const Words& letter : letters) {
        ui::Writing writing;
        writing.at = {x, 11.0F};
        writing.text = {.words = letter.text, .style = style(letter)};
        sketch.add(writing);
        x += words_width(letter) + kGap;
    }
    sprite(rect, std::move(sketch), target);
    return rect;
}

void Page::look_in_token(const Rect& languages) {
    const bool inside = view_.state.throwing.looks_in;
    // The label is on the side towards the picture's middle.
    const bool is_right_of = languages.centre().x < 0.5F * width();
    const Rect rect{is_right_of ? languages.right() + 16.0F : languages.x - 100.0F, languages.y - 3.0F, 84.0F,
                    66.0F};
    token(rect, inside ? Look::kToken : Look::kOutline, kiosk::Button::kLookIn,
          named(inside ? "ctl.front" : "ctl.inside"), 0, Icon::kLookIn, false);
}

void Page::language_token(const Rect& rect, int place, bool chosen) {
    const kiosk::Language& tongue = language(place);
    const Look look = chosen ? Look::kPrimary : Look::kToken;
    const int target = add_target(rect, kiosk::Button::kLanguage, place, tongue.shown("name"), false);
    if (chosen) say_chosen();
    ui::Sketch sketch;
    const Rect body{kShadowReach, kShadowReach, rect.width, rect.height};
    token_body(sketch, body, look, false);
    sprite(rect.grown(kShadowReach), std::move(sketch), target);
    // On a narrow token the tick stands above the name, unless it is too low for that.
    constexpr float kNarrow = 260.0F;
    constexpr float kLow = 60.0F;
    const bool is_narrow = rect.width < kNarrow;
    const bool is_small = is_narrow || rect.height < kLow;
    const bool is_above = is_narrow && rect.height >= kLow;
    const float tick_side = is_small ? 22.0F : 38.0F;
    if (chosen) {
        ui::Sketch tick;
        add_icon(tick, Icon::kCheck, {0.0F, 0.0F}, tick_side, design::kInk);
        const vec2 at = is_above ? vec2(rect.centre().x - 0.5F * tick_side, rect.y + 1.0F)
                                 : vec2(rect.x + 18.0F, rect.centre().y - 0.5F * tick_side - 3.0F);
        sprite({at.x, at.y, tick_side, tick_side}, std::move(tick), target);
    }
    const float air = is_above ? 14.0F : is_small ? 44.0F : 64.0F;
    const float line = is_small ? 43.0F : 66.0F;
    const float lift = is_above ? -2.0F : is_small ? 2.0F : 4.0F;
    fixed_words({rect.x + air, rect.centre().y - 0.5F * line - lift, rect.width - 2.0F * air, line},
                {.text = tongue.shown("name"),
                 .type = design::serif(is_small ? 32.0F : 46.0F, line, design::kLeastTextSize),
                 .colour = design::kInk,
                 .align = ui::Align::kCentre,
                 .language = place});
    composition_.items.back().target = target;
}

void Page::toggle(const Rect& rect, Icon icon, bool on, kiosk::Button button, const Name& name) {
    const int target = add_target(rect, button, on ? 1 : 0, name, false);
    if (on) say_chosen();
    ui::Sketch sketch;
    const Rect body{kShadowReach, kShadowReach, rect.width, rect.height};
    token_body(sketch, body, on ? Look::kPrimary : Look::kToken, false);
    const float side = 46.0F;
    const float shift = on ? 18.0F : 0.0F;
    add_icon(sketch, icon, body.centre() - vec2(0.5F * side + shift, 0.5F * side + 3.0F), side, design::kInk);
    if (on) add_icon(sketch, Icon::kCheck, body.centre() + vec2(16.0F, -16.0F), 28.0F, design::kInk);
    sprite(rect.grown(kShadowReach), std::move(sketch), target);
}

// The backgrounds of screens: the museum's wall and shelf, the ledge of the bench.

void Page::shade(const Rect& rect, const std::function<Colour(vec2)>& colour_at) {
    constexpr int kColumns = 32;
    constexpr int kRows = 18;
    const vec2 step(rect.width / kColumns, rect.height / kRows);
    const auto corner = [&](int column, int row) {
        return vec2(rect.x, rect.y) + step * vec2(static_cast<float>(column), static_cast<float>(row));
    };
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            const vec2 at = corner(column, row);
            box({at.x, at.y, step.x, step.y},
                {colour_at(at), colour_at(corner(column + 1, row)), colour_at(corner(column + 1, row + 1)),
                 colour_at(corner(column, row + 1))});
        }
    }
}

void Page::museum(vec2 light, vec2 reach, float strength) {
    covers();
    const Rect& bounds = composition_.bounds;
    const vec2 wall_centre(0.5F * bounds.width, 0.34F * bounds.height);
    const vec2 wall_reach(0.75F * bounds.width, 0.85F * bounds.height);
    shade(bounds, [&](vec2 at) {
        const float away = std::min(1.0F, glm::length((at - wall_centre) / wall_reach));
        const Colour wall = away < 0.48F ? ui::mix(design::kWallLight, design::kWall, away / 0.48F)
                                         : ui::mix(design::kWall, design::kWallDark, (away - 0.48F) / 0.52F);
        const float near = std::max(0.0F, 1.0F - glm::length((at - light) / reach));
        return ui::mix(wall, ui::hex(0xffe6be), strength * near).with_alpha(1.0F);
    });
}

void Page::shelf(float top, float thickness) {
    const float wide = width();
    // The upper face is lit towards its middle and has a paler front edge.
    const Colour middle = design::kShelf;
    const Colour end = ui::mix(design::kShelf, design::kNight, 0.45F);
    const float face = thickness * 0.72F;
    across({0.0F, top, 0.5F * wide, face}, end, middle);
    across({0.5F * wide, top, 0.5F * wide, face}, middle, end);
    const Colour edge = design::kShelfEdge;
    const Colour dark_edge = ui::mix(edge, design::kNight, 0.5F);
    across({0.0F, top + face, 0.5F * wide, thickness - face}, dark_edge, edge);
    across({0.5F * wide, top + face, 0.5F * wide, thickness - face}, edge, dark_edge);
    down({0.0F, top + thickness, wide, 64.0F}, ui::hex(0x0a0603, 0.62F), ui::hex(0x0a0603, 0.0F));
}

void Page::pot_shadow(float centre_x, float y, float radius, float height) {
    ui::Sketch sketch;
    const Rect rect{centre_x - radius, y - height, 2.0F * radius, 2.0F * height};
    sketch.add(ui::Ellipse{{0.0F, 0.0F, rect.width, rect.height},
                           ui::Fill::round(ui::hex(0x0c0703, 0.72F), ui::hex(0x0c0703, 0.0F))});
    sprite(rect, std::move(sketch));
}

Rect Page::stand(const pot::Section& shape, float u_per_mm, vec2 foot) {
    const float px_per_u = composition_.px_per_u;
    const PotExtent extent = pot_extent(shape, u_per_mm * px_per_u, kMuseumElevationRad);
    const float foot_radius = shape.outside.empty() ? 0.0F : shape.outside.front().x * u_per_mm;
    pot_shadow(foot.x + 0.18F * foot_radius, foot.y, 1.9F * foot_radius + 6.0F, 5.0F + 0.09F * foot_radius);
    return {foot.x - extent.foot_px.x / px_per_u, foot.y - extent.foot_px.y / px_per_u,
            static_cast<float>(extent.width_px) / px_per_u, static_cast<float>(extent.height_px) / px_per_u};
}

Rect Page::pot(const pot::Section& shape, const finish::GlazeMaterial& glaze, float u_per_mm, vec2 foot,
               float brightness) {
    const Rect rect = stand(shape, u_per_mm, foot);
    const auto picture = store_.pot(shape, glaze, u_per_mm * composition_.px_per_u, kMuseumElevationRad);
    ui::Sketch sketch;
    ui::Picture item;
    // The store keeps the picture; the sketch only borrows its pixels.
    item.painting = std::shared_ptr<const ui::Painting>(picture, &picture->painting);
    item.hash = shape.hash() ^ static_cast<std::uint64_t>(std::lround(brightness * 1000.0F)) ^
                (static_cast<std::uint64_t>(glaze.glaze) << 40U) ^ glaze.id.size();
    item.rect = {0.0F, 0.0F, rect.width, rect.height};
    item.brightness = brightness;
    sketch.add(item);
    sprite(rect, std::move(sketch));
    return rect;
}

Rect Page::turning_pot(const pot::Section& shape, const finish::GlazeMaterial& glaze, float u_per_mm,
                       vec2 foot) {
    const Rect rect = stand(shape, u_per_mm, foot);
    std::uint64_t key = 0;
    auto turning = store_.turning(shape, glaze, u_per_mm * composition_.px_per_u, kMuseumElevationRad, key);
    if (!turning) return rect;
    picture(rect, turning->at(0.0), key);
    composition_.items.back().turning = std::move(turning);
    return rect;
}

void Page::scene_ends() {
    const vec3 edges = view_.scene_edges_px / composition_.px_per_u;
    constexpr float kSoft = 110.0F;
    const Colour night = design::kNight;
    const Colour clear = design::kNight.with_alpha(0.0F);
    if (edges.y > 1.0F) {
        down({0.0F, 0.0F, width(), edges.y}, night, night);
        down({0.0F, edges.y, width(), kSoft}, night, clear);
    }
    if (edges.x > 1.0F) {
        across({0.0F, 0.0F, edges.x, height()}, night, night);
        across({edges.x, 0.0F, kSoft, height()}, night, clear);
    }
    if (edges.z < width() - 1.0F) {
        across({edges.z, 0.0F, width() - edges.z, height()}, night, night);
        across({edges.z - kSoft, 0.0F, kSoft, height()}, clear, night);
    }
}

void Page::ledge(float y) {
    const float wide = width();
    const float deep = height() - y;
    down({0.0F, y - 46.0F, wide, 46.0F}, design::kNight.with_alpha(0.0F), design::kNight.with_alpha(0.42F));
    down({0.0F, y, wide, 26.0F}, design::kNightTop, ui::hex(0x211812));
    down({0.0F, y + 26.0F, wide, deep - 26.0F}, ui::hex(0x211812), design::kNight);
    const Colour dim = ui::hex(0xdeba8c, 0.15F);
    const Colour lit = ui::hex(0xdeba8c, 0.75F);
    across({0.0F, y, 0.45F * wide, 3.0F}, dim, lit);
    across({0.45F * wide, y, 0.55F * wide, 3.0F}, lit, dim);
}

std::shared_ptr<const ui::Painting> PaintingStore::get(const ui::Sketch& sketch, std::uint64_t& key) {
    if (paints_ == Paints::kNothing) return nothing();
    key = std::max<std::uint64_t>(1, sketch.hash());
    Kept<ui::Painting>& kept = paintings_[key];
    if (!kept.value) kept.value = std::make_shared<const ui::Painting>(painter_.paint(sketch));
    kept.unused = 0;
    return kept.value;
}

std::shared_ptr<const PotPicture> PaintingStore::pot(const pot::Section& shape,
                                                     const finish::GlazeMaterial& glaze, float px_per_mm,
                                                     float elevation_rad) {
    if (paints_ == Paints::kNothing) return std::make_shared<const PotPicture>();
    Kept<PotPicture>& kept = pots_[key_of(shape, glaze, px_per_mm, elevation_rad)];
    if (!kept.value)
        kept.value = std::make_shared<const PotPicture>(paint_pot(shape, glaze, px_per_mm, elevation_rad));
    kept.unused = 0;
    return kept.value;
}

std::shared_ptr<const TurningPot> PaintingStore::turning(const pot::Section& shape,
                                                         const finish::GlazeMaterial& glaze, float px_per_mm,
                                                         float elevation_rad, std::uint64_t& key) {
    key = key_of(shape, glaze, px_per_mm, elevation_rad);
    if (paints_ == Paints::kNothing) return nullptr;
    Kept<TurningPot>& kept = turning_[key];
    if (!kept.value) kept.value = std::make_shared<const TurningPot>(shape, glaze, px_per_mm, elevation_rad);
    kept.unused = 0;
    return kept.value;
}

// Sums the bytes of unused paintings by age, in compositions since their last use.
void PaintingStore::forget_unused() {
    if (paints_ != Paints::kAll) return;
    std::array<std::size_t, kPatience + 1> unused_bytes{};
    const auto look = [&](auto& kept) {
        for (auto& [key, entry] : kept) {
            if (++entry.unused > 1 && entry.unused <= kPatience + 1)
                unused_bytes[static_cast<std::size_t>(entry.unused - 1)] += bytes_of(*entry.value);
        }
    };
    look(paintings_);
    look(pots_);
    look(turning_);
    int most_unused = 1;
    for (std::size_t bytes = 0; most_unused <= kPatience; ++most_unused) {
        bytes += unused_bytes[static_cast<std::size_t>(most_unused)];
        if (bytes > kMostUnusedBytes) break;
    }
    const auto forget = [&](auto& kept) {
        std::erase_if(kept, [&](const auto& entry) { return entry.second.unused > most_unused; });
    };
    forget(paintings_);
    forget(pots_);
    forget(turning_);
}

}  // namespace onggi::screens

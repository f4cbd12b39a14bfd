// The design's parts: tokens, steppers, cards, niches.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "game/screens/page/page.h"

namespace onggi::screens {
namespace {

using ui::Colour;
using ui::Fill;
using ui::Rect;

constexpr float kShadowReach = 14.0F;  // of a token, u

}  // namespace

// A glazed pebble with a foot of bare clay; pressed, it sinks until the foot is gone.
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

int Page::token(const Rect& rect, Look look, kiosk::Button button, std::string_view name, int value,
                std::optional<Icon> icon, bool with_words, bool repeats) {
    const int target = add_target(rect, button, value, std::string(name), repeats);
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
    Words words{.text = std::string(name), .type = design::bold(30.0F, 38.0F), .colour = ink};
    const float room = rect.width - (is_narrow ? 20.0F : 36.0F) - icon_side - gap;
    // One line, as large as it can be, clear of the rounded corners.
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
    const float scale = std::exchange(text_scale_, 1.0F);  // the size is found already
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

void Page::stepper(const Rect& rect, Icon icon, int dots, int on, kiosk::Button less, kiosk::Button more,
                   const std::string& name, bool reversed) {
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
        if (i >= on) sketch.add(ui::Ellipse{dot.grown(-2.0F), Fill::flat(ui::hex(0xf3e9d8))});
    }
    sprite(rect.grown(kShadowReach), std::move(sketch));
    if (less == kiosk::Button::kNone) {
        composition_.items.back().alpha = design::kRestingAlpha;
        return;
    }
    const Rect first{rect.x, rect.y, end, rect.height};
    const Rect last{rect.right() - end, rect.y, end, rect.height};
    add_target(reversed ? last : first, less, 0, name + " \xe2\x88\x92", true);  // U+2212
    add_target(reversed ? first : last, more, 0, name + " +", true);
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

int Page::card_target(const Rect& rect, bool celadon, kiosk::Button button, int value,
                      const std::string& name) {
    const int target = add_target(rect, button, value, name, false);
    card(rect, celadon ? design::kCeladonHi : design::kHanji, celadon ? ui::hex(0xb3ccac) : design::kHanji,
         target);
    return target;
}

int Page::card_niche(const Rect& rect, bool chosen, kiosk::Button button, int value,
                     const std::string& name) {
    const int target = add_target(rect, button, value, name, false);
    if (chosen) {
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
    const int target = add_target(rect, kiosk::Button::kLanguages, 0, t("lang.title"), false);
    ui::Sketch sketch;
    const Rect body{0.0F, 0.0F, rect.width, rect.height};
    token_body(sketch, body, Look::kOutline, false);
    const auto letter = [&](const char* text, float x, const char* family) {
        ui::Writing writing;
        writing.at = {x, 11.0F};
        writing.text = {.words = text,
                        .style = {.family = family,
                                  .bold = true,
                                  .size = 29.0F,
                                  .line_height = 36.0F,
                                  .colour = design::kSlip}};
        sketch.add(writing);
    };
    letter("가", 27.0F, design::kUiFamily);
    letter("A", 71.0F, design::kUiFamily);
    letter("ع", 105.0F, design::kUiFamilyArabic);
    sprite(rect, std::move(sketch), target);
    return rect;
}

void Page::look_in_token(const Rect& languages) {
    const bool inside = view_.state.throwing.looks_in;
    // Towards the middle of the picture.
    const bool is_right_of = languages.centre().x < 0.5F * width();
    const Rect rect{is_right_of ? languages.right() + 16.0F : languages.x - 100.0F, languages.y - 3.0F, 84.0F,
                    66.0F};
    token(rect, inside ? Look::kToken : Look::kOutline, kiosk::Button::kLookIn,
          t(inside ? "ctl.front" : "ctl.inside"), 0, Icon::kLookIn, false);
}

void Page::language_token(const Rect& rect, int place, bool chosen) {
    const kiosk::Language& tongue = language(place);
    const Look look = chosen ? Look::kPrimary : Look::kToken;
    const int target = add_target(rect, kiosk::Button::kLanguage, place, tongue.shown("name"), false);
    ui::Sketch sketch;
    const Rect body{kShadowReach, kShadowReach, rect.width, rect.height};
    token_body(sketch, body, look, false);
    sprite(rect.grown(kShadowReach), std::move(sketch), target);
    if (chosen) {
        ui::Sketch tick;
        add_icon(tick, Icon::kCheck, {0.0F, 0.0F}, 38.0F, design::kInk);
        sprite({rect.x + 26.0F, rect.centre().y - 22.0F, 38.0F, 38.0F}, std::move(tick), target);
    }
    const float line = 66.0F;
    fixed_words({rect.x + 60.0F, rect.centre().y - 0.5F * line - 4.0F, rect.width - 120.0F, line},
                {.text = tongue.shown("name"),
                 .type = design::serif(46.0F, line),
                 .colour = design::kInk,
                 .align = ui::Align::kCentre,
                 .language = place});
    composition_.items.back().target = target;
}

void Page::toggle(const Rect& rect, Icon icon, bool on, kiosk::Button button, const std::string& name) {
    const int target = add_target(rect, button, on ? 1 : 0, name, false);
    ui::Sketch sketch;
    const Rect body{kShadowReach, kShadowReach, rect.width, rect.height};
    token_body(sketch, body, on ? Look::kPrimary : Look::kToken, false);
    const float side = 46.0F;
    const float shift = on ? 18.0F : 0.0F;
    add_icon(sketch, icon, body.centre() - vec2(0.5F * side + shift, 0.5F * side + 3.0F), side, design::kInk);
    if (on) add_icon(sketch, Icon::kCheck, body.centre() + vec2(16.0F, -16.0F), 28.0F, design::kInk);
    sprite(rect.grown(kShadowReach), std::move(sketch), target);
}

}  // namespace onggi::screens

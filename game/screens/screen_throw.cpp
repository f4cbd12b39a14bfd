// Throwing: the clay and nothing over it but the cue, which the stage draws; what can be done stands on the
// ledge (throw_ledge.cpp). The danger is a sign on the pot, a card and a section of the wall.
#include <fmt/format.h>

#include <algorithm>

#include "game/screens/page/ledge_parts.h"
#include "game/screens/screens.h"

namespace onggi::screens {
namespace {

using kiosk::Button;
using ui::Rect;

float ledge_y(const Page& page) {
    return screens::ledge_y(page.shape(), page.height(), page.view().state.comfort);
}

// The button way for every drag, for who asks for controls within reach, and for who has one switch.
bool has_hand_pad(const View& view) {
    return view.state.comfort.reach || view.scans;
}

// Where pot, tool and hands are to be seen: no words there but on cards.
Rect pot_box(const Page& page) {
    if (page.view().state.comfort.reach)
        return {0.38F * page.width(), 0.42F * page.height(), 0.2F * page.width(),
                ledge_y(page) - 0.42F * page.height()};
    const bool padded = has_hand_pad(page.view());  // it stands beside the pot, over the wheel's edge
    const float top = ledge_y(page);
    return page.by_shape(Rect{340.0F, 56.0F, 600.0F, top - 70.0F},
                         Rect{260.0F, 114.0F, padded ? 450.0F : 510.0F, top - 124.0F},
                         Rect{90.0F, 240.0F, padded ? 330.0F : 550.0F, top - 260.0F});
}

// Along the target's outline. Drawn in the scene's pixels, never mirrored.
void outline(Page& page) {
    const View& view = page.view();
    const float u = 1.0F / page.px_per_u();
    for (const std::vector<vec2>& line : view.outline_px) {
        std::vector<vec2> points;
        for (const vec2& point : line)
            points.push_back(point * u);
        page.dotted(points);
    }
}

// A bowl that waits for the other one.
void bowl_aside(Page& page) {
    const View& view = page.view();
    if (!view.aside) return;
    const vec2 foot = view.aside_foot_px / page.px_per_u();
    const float scale = view.aside_px_per_mm / page.px_per_u();
    const float reach = view.aside->radius_mm() * scale;
    constexpr float kDaylight = 1.25F;  // beside the evening museum's, for which such pictures are lit
    if (foot.x < -0.4F * reach || foot.y > ledge_y(page)) return;
    page.pot(*view.aside, finish::wet_clay(), scale, foot, kDaylight);
}

// Round what lies on the bench and may be picked up there.
void bench_rings(Page& page) {
    const float u = 1.0F / page.px_per_u();
    for (const BenchTool& tool : page.view().bench) {
        const vec2 size = tool.size_px * u;
        const vec2 corner = tool.centre_px * u - 0.5F * size;
        if (corner.y + size.y > ledge_y(page)) continue;
        const float r = 0.42F * std::min(size.x, size.y);
        constexpr float kMargin = 6.0F;
        const float left = kMargin;
        const float top = kMargin;
        const float right = kMargin + size.x;
        const float low = kMargin + size.y;
        const std::string path = fmt::format(
            "M{:.1f} {:.1f} H{:.1f} Q{:.1f} {:.1f} {:.1f} {:.1f} V{:.1f} Q{:.1f} {:.1f} {:.1f} {:.1f} "
            "H{:.1f} "
            "Q{:.1f} {:.1f} {:.1f} {:.1f} V{:.1f} Q{:.1f} {:.1f} {:.1f} {:.1f} Z",
            left + r, top, right - r, right, top, right, top + r, low - r, right, low, right - r, low,
            left + r, left, low, left, low - r, top + r, left, top, left + r, top);
        ui::Sketch sketch;
        sketch.add(ui::Shape{
            .path = path, .stroke = design::kNight.with_alpha(0.55F), .stroke_width = 7.0F, .dash = 13.0F});
        sketch.add(ui::Shape{.path = path, .stroke = design::kOutline, .stroke_width = 4.4F, .dash = 13.0F});
        page.sprite(
            {corner.x - kMargin, corner.y - kMargin, size.x + 2.0F * kMargin, size.y + 2.0F * kMargin},
            std::move(sketch));
    }
}

void warning_card(Page& page) {
    const View& view = page.view();
    const bool tall = page.is_tall();
    const bool square = page.is_square();
    const bool low = has_hand_pad(view) && page.shape() == Shape::kWide;
    const float width = page.width();
    // Brought low, it stands across from the hand's keys.
    const Rect card =
        tall  ? Rect{60.0F, 104.0F, 600.0F, 128.0F}
        : low ? page.mirrored({32.0F, 290.0F, 376.0F, 156.0F})
              : page.mirrored({width - (square ? 360.0F : 408.0F), 112.0F, square ? 336.0F : 376.0F, 156.0F});
    if (view.warning_at_px) {
        const vec2 from =
            tall ? vec2(0.5F * width, card.bottom())
                 : vec2(page.right_to_left() != low ? card.right() : card.x, card.bottom() - 28.0F);
        const vec2 to = *view.warning_at_px / page.px_per_u();
        const vec2 corner = glm::min(from, to) - 6.0F;
        const vec2 size = glm::abs(to - from) + 12.0F;
        const std::string path = fmt::format("M{:.1f} {:.1f} L{:.1f} {:.1f}", from.x - corner.x,
                                             from.y - corner.y, to.x - corner.x, to.y - corner.y);
        ui::Sketch sketch;
        sketch.add(ui::Shape{.path = path, .stroke = design::kNight.with_alpha(0.6F), .stroke_width = 7.0F});
        sketch.add(ui::Shape{.path = path, .stroke = ui::hex(0xfff1d6), .stroke_width = 3.5F});
        page.sprite({corner.x, corner.y, size.x, size.y}, std::move(sketch));
    }
    const char* const key = view.state.throwing.warning == kiosk::Warning::kThin  ? "warn.thin"
                            : view.state.throwing.warning == kiosk::Warning::kWet ? "warn.wet"
                                                                                  : "warn.fast";
    page.card(card, design::kHanji, design::kHanji);
    const Rect inner{card.x + 20.0F, card.y + 14.0F, card.width - 40.0F, card.height - 22.0F};
    page.fitted_words(
        inner, page.fitted(
                   {{.text = page.t(key), .type = design::bold(30.0F, 40.0F), .colour = design::kRust},
                    {.text = page.t(std::string(key) + "2"), .type = {28.0F, 38.0F}, .colour = design::kInk}},
                   {inner.width, inner.height + 4.0F}, 4.0F));
}

// As wide as its words, up to that; where they need more lines than it has room for, it grows down.
void chip(Page& page, const Rect& rect, const std::string& text) {
    const Words words{.text = text, .type = design::kLabel, .align = ui::Align::kCentre};
    const float wide = std::min(rect.width, page.words_width(words) * page.text_scale() + 44.0F);
    const float least = page.words_size(words, 1.0F, wide - 36.0F).height + 16.0F;
    const Rect body{rect.centre().x - 0.5F * wide, rect.y, wide, std::max(rect.height, least)};
    ui::Sketch sketch;
    sketch.add(ui::Box{
        {0.0F, 0.0F, body.width, body.height}, 24.0F, ui::Fill::flat(design::kNight.with_alpha(0.86F))});
    page.sprite(body, std::move(sketch));
    page.words({body.x + 18.0F, body.y + 8.0F, body.width - 36.0F, body.height - 14.0F}, words, true);
}

// Why the clay does less than the finger asks, for the stage to set beside the cue.
void add_guards(Page& page) {
    for (int guard = 1; guard < kCueGuardCount; ++guard) {
        constexpr float kMostWide = 420.0F;
        Words words{.text = page.t(key_of(static_cast<CueGuard>(guard))), .type = design::kLabel};
        const float scale = std::max(1.0F, std::min(page.text_scale(), kMostWide / page.words_width(words)));
        words.type = words.type.times(scale);
        page.keep_guard_words(static_cast<CueGuard>(guard), page.loose_words(words, 0.0F, true));
    }
}

}  // namespace

void draw_throw(Page& page) {
    const View& view = page.view();
    const float y = ledge_y(page);
    page.keep_clear(pot_box(page));
    page.scene_ends();
    bowl_aside(page);
    outline(page);
    bench_rings(page);
    const bool warned = view.state.throwing.warning != kiosk::Warning::kNone;
    page.ledge(y);
    if (warned) {
        warning_card(page);
    } else {
        add_jar_card(page);
    }
    // The ring comes to the hand's keys before it comes to what ends the throwing.
    const kiosk::Throwing& throwing = view.state.throwing;
    const bool works_clay = !throwing.shown && !throwing.tray && throwing.held != kiosk::Held::kWire &&
                            throwing.jar.step != kiosk::JarStep::kAside;
    if (has_hand_pad(view) && works_clay) add_hand_pad(page);
    add_throw_ledge(page);
    // Brought low, they stand over the hand's keys, or across from them.
    const Rect languages = page.languages_token(low_languages(page, page.width() - 182.0F));
    add_forces(page);
    add_guards(page);
    if (view.can_look_in) page.look_in_token(languages);
    const float middle = 0.5F * page.width();
    if (view.wire_at_px) {
        const vec2 at = *view.wire_at_px / page.px_per_u();
        constexpr float kWide = 300.0F;
        constexpr float kHigh = 48.0F;
        const float x = std::min(at.x, page.width() - kWide - 16.0F);
        chip(page, {x, std::clamp(at.y + 20.0F, 120.0F, y - 2.0F * kHigh), kWide, kHigh},
             page.t("wire.off", page.digits(std::to_string(view.wire_off_mm))));
    }
    if (view.state.device_lost || view.state.force_rests) {
        const bool tall = page.is_tall();
        const float wide = tall ? page.width() - 64.0F : std::min(660.0F, page.width() - 400.0F);
        chip(page, {middle - 0.5F * wide, tall ? 104.0F : 28.0F, wide, 84.0F},
             page.t(view.state.device_lost ? "dev.lost" : "dev.rest"));
    } else if (throwing.jar.is_low || throwing.jar.rims_apart) {
        const bool tall = page.is_tall();
        const float wide = tall ? page.width() - 64.0F : std::min(660.0F, page.width() - 400.0F);
        chip(page, {middle - 0.5F * wide, tall ? 104.0F : 28.0F, wide, 84.0F},
             page.t(throwing.jar.is_low ? "moon.low" : "moon.more"));
    } else if (!view.heard.empty()) {
        // Where hand pad and caption have no room beside each other, the caption stands across from the pad.
        const bool beside = page.is_tall() && has_hand_pad(view);
        chip(page,
             beside ? page.mirrored({24.0F, y - 58.0F, 390.0F, 48.0F})
                    : Rect{middle - 200.0F, y - 58.0F, 400.0F, 48.0F},
             page.t(view.heard));
    }
    if (view.state.throwing.target && !view.outline_px.empty() &&
        throwing.jar.step == kiosk::JarStep::kNone && throwing.steps_done < kiosk::kTeachingSteps &&
        !warned) {
        const float width = page.shape() == Shape::kWide ? 300.0F : 420.0F;
        chip(page, page.mirrored({24.0F, 28.0F, width, 84.0F}), page.t("out.target"));
    }
}

}  // namespace onggi::screens

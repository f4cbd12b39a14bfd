#include "tests/unit/screens/audit_checks.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "game/screens/page/design.h"
#include "game/screens/page/legibility.h"
#include "game/screens/stage.h"
#include "tests/unit/screens/flatten.h"

namespace onggi::screens {
namespace {

using ui::Rect;

constexpr float kLeastContrast = 4.5F;

std::string where(const Rect& rect) {
    return fmt::format("{:.0f},{:.0f} {:.0f}x{:.0f}", rect.x, rect.y, rect.width, rect.height);
}

bool is_staff(const View& view) {
    return view.state.panel == kiosk::Panel::kStaff || view.state.panel == kiosk::Panel::kPin;
}

void knows_every_letter_and_cuts_no_word(const SampleView&, const Composition& screen) {
    for (const Writing& text : screen.writings) {
        EXPECT_EQ(text.unknown_glyphs, 0) << text.words;
        EXPECT_FALSE(text.too_wide) << text.words << " in " << where(text.within);
        EXPECT_LE(text.rect.width, text.within.width + 1.0F) << text.words;
        EXPECT_LE(text.rect.bottom(), text.within.bottom() + 2.0F)
            << text.words << " in " << where(text.within);
    }
}

void writes_large_enough_to_read(const SampleView&, const Composition& screen) {
    for (const Writing& text : screen.writings)
        EXPECT_GE(text.size, design::kLeastTextSize - 0.01F) << text.words;
}

void keeps_words_and_targets_on_the_screen(const SampleView&, const Composition& screen) {
    for (const Writing& text : screen.writings) {
        EXPECT_GE(text.rect.x, 12.0F) << text.words;
        EXPECT_LE(text.rect.right(), screen.bounds.width - 12.0F) << text.words;
        EXPECT_LE(text.rect.bottom(), screen.bounds.height + 1.0F) << text.words;
    }
    for (const Target& target : screen.targets) {
        EXPECT_GE(target.rect.x, 15.9F) << target.name;
        EXPECT_LE(target.rect.right(), screen.bounds.width - 15.9F) << target.name;
        EXPECT_LE(target.rect.bottom(), screen.bounds.height - 11.9F) << target.name;
    }
}

void makes_every_target_large_enough_to_touch(const SampleView& sample, const Composition& screen) {
    for (const Target& target : screen.targets) {
        const float least = std::min(target.rect.width, target.rect.height);
        EXPECT_GE(least, design::kLeastTarget - 0.01F) << target.name << ' ' << sample.name;
        EXPECT_GE(double{least * screen.mm_per_u}, kLeastTargetMm) << target.name << ' ' << sample.name;
    }
}

void names_every_target(const SampleView&, const Composition& screen) {
    for (const Target& target : screen.targets) {
        EXPECT_FALSE(target.name.empty());
        EXPECT_NE(target.button, kiosk::Button::kNone) << target.name;
    }
}

void lays_no_target_over_another(const SampleView&, const Composition& screen) {
    for (std::size_t i = 0; i < screen.targets.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const Rect shared = overlap(screen.targets[i].rect, screen.targets[k].rect);
            EXPECT_FALSE(shared.width > 0.5F && shared.height > 0.5F)
                << screen.targets[i].name << " and " << screen.targets[k].name;
        }
    }
}

// A touchable pot in the picture must not overlap a target, and must be at least as large as a target.
void lets_a_picture_be_touched_clear_of_targets(const SampleView&, const Composition& screen) {
    for (std::size_t i = 0; i < screen.targets.size(); ++i) {
        const Rect& also = screen.targets[i].also;
        if (also.width <= 0.0F) continue;
        EXPECT_GE(std::min(also.width, also.height), design::kLeastTarget) << screen.targets[i].name;
        for (std::size_t k = 0; k < screen.targets.size(); ++k) {
            if (k == i) continue;
            for (const Rect& other : {screen.targets[k].rect, screen.targets[k].also}) {
                const Rect shared = overlap(also, other);
                EXPECT_FALSE(shared.width > 0.5F && shared.height > 0.5F)
                    << screen.targets[i].name << " and " << screen.targets[k].name;
            }
        }
    }
}

void lays_no_words_over_others(const SampleView&, const Composition& screen) {
    for (std::size_t i = 0; i < screen.writings.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if (screen.writings[i].over) continue;
            const Rect shared = overlap(screen.writings[i].rect, screen.writings[k].rect);
            EXPECT_FALSE(shared.width > 2.0F && shared.height > 3.0F)
                << screen.writings[i].words << " and " << screen.writings[k].words;
        }
    }
}

// The chips in the upper half of the throwing leave its tokens free.
void lays_no_chip_over_a_target(const SampleView& sample, const Composition& screen) {
    if (sample.view->state.screen != kiosk::Screen::kThrow) return;
    for (const Writing& text : screen.writings) {
        const vec2 middle = text.rect.centre();
        const bool is_of_target = std::any_of(screen.targets.begin(), screen.targets.end(),
                                              [&](const Target& one) { return one.rect.contains(middle); });
        if (is_of_target || text.over || middle.y > 0.5F * screen.bounds.height) continue;
        const Rect& words = text.within;
        const Rect chip{words.x - 18.0F, words.y - 8.0F, words.width + 36.0F, words.height + 14.0F};
        for (const Target& target : screen.targets) {
            const Rect shared = overlap(chip, target.rect);
            EXPECT_FALSE(shared.width > 0.5F && shared.height > 0.5F)
                << text.words << " on " << target.name << ' ' << sample.name;
        }
    }
}

void writes_on_no_pot(const SampleView&, const Composition& screen) {
    for (const Rect& pot : screen.pots) {
        const Rect inner = pot.grown(-8.0F);
        for (const Writing& text : screen.writings) {
            if (text.on_pot) continue;
            const Rect shared = overlap(inner, text.rect);
            EXPECT_FALSE(shared.width > 0.0F && shared.height > 0.0F) << text.words << " on " << where(pot);
        }
    }
}

// The reach of a sitting or small visitor: on every screen of a visit.
void keeps_reach(const SampleView& sample, const Composition& screen) {
    if (!sample.view->state.comfort.reach || is_staff(*sample.view)) return;
    for (const Target& target : screen.targets)
        EXPECT_GE(target.rect.y, 0.5F * screen.bounds.height) << target.name;
}

}  // namespace

void audit_contrast(const SampleView& sample, const Composition& screen) {
    // The brightest thing the scene has to show is its window.
    const asset::Image behind = flatten(screen, ui::hex(0xf5f9fd), false);
    // The name of the target in the ring hides the words below.
    constexpr float kChipEdge = 18.0F;
    const auto hides = [&](const Writing& other, const Writing& text) {
        const Rect shared = overlap(other.within.grown(kChipEdge), text.rect);
        return other.over && &other != &text && shared.width > 0.0F && shared.height > 0.0F;
    };
    // In the small painting a pixel blurs the ring into the label below.
    const auto is_on_ring = [&](vec2 at) {
        const int focus = sample.view->focus;
        if (focus < 0 || focus >= static_cast<int>(screen.targets.size())) return false;
        const Rect& target = screen.targets[static_cast<std::size_t>(focus)].rect;
        return target.grown(18.0F).contains(at) && !target.grown(1.0F).contains(at);
    };
    for (const Writing& text : screen.writings) {
        if (std::any_of(screen.writings.begin(), screen.writings.end(),
                        [&](const Writing& other) { return hides(other, text); }))
            continue;
        const Rect px = text.rect.scaled(screen.px_per_u);
        std::vector<float> ratios;
        for (int y = static_cast<int>(px.y); y < static_cast<int>(px.bottom()); y += 3) {
            for (int x = static_cast<int>(px.x); x < static_cast<int>(px.right()); x += 3) {
                if (x < 0 || y < 0 || x >= behind.width || y >= behind.height) continue;
                if (is_on_ring(vec2(x, y) / screen.px_per_u)) continue;
                const std::uint8_t* pixel = behind.rgba.data() + (static_cast<std::size_t>(y) *
                                                                      static_cast<std::size_t>(behind.width) +
                                                                  static_cast<std::size_t>(x)) *
                                                                     4;
                const ui::Colour ground{static_cast<float>(pixel[0]) / 255.0F,
                                        static_cast<float>(pixel[1]) / 255.0F,
                                        static_cast<float>(pixel[2]) / 255.0F, 1.0F};
                ratios.push_back(ui::contrast(text.colour, ground));
            }
        }
        if (ratios.empty()) continue;
        // Ignores the worst half per cent: antialiased edges of the background.
        const auto worst = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 200);
        std::nth_element(ratios.begin(), worst, ratios.end());
        EXPECT_GE(*worst, kLeastContrast) << text.words << " at " << where(text.rect);
    }
}

void audit_layout(const SampleView& sample, const Composition& screen) {
    knows_every_letter_and_cuts_no_word(sample, screen);
    writes_large_enough_to_read(sample, screen);
    keeps_words_and_targets_on_the_screen(sample, screen);
    makes_every_target_large_enough_to_touch(sample, screen);
    names_every_target(sample, screen);
    lays_no_target_over_another(sample, screen);
    lets_a_picture_be_touched_clear_of_targets(sample, screen);
    lays_no_words_over_others(sample, screen);
    lays_no_chip_over_a_target(sample, screen);
    writes_on_no_pot(sample, screen);
    keeps_reach(sample, screen);
}

void audit_room(const SampleView& sample, const Composition& screen) {
    const auto composed = std::make_shared<const Composed>(Composed{sample.view, screen});
    Stage stage;
    stage.take(composed, 0.0);
    static_cast<void>(stage.draw({.now_s = 0.0}));
    for (const Item& item : screen.items) {
        if (!item.painting) continue;
        EXPECT_LE(item.painting->width, stage.atlas_side_px());
        EXPECT_LE(item.painting->height, stage.atlas_side_px() / 2);
    }
    static_cast<void>(stage.draw({.now_s = 1.0}));
    EXPECT_TRUE(stage.uploads().empty()) << "expected room for all pictures, found them to take turns";
}

}  // namespace onggi::screens

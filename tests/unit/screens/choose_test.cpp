// The cards of the shelf: each is as high as its words.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "game/visit/steps.h"
#include "tests/unit/screens/sample_views.h"

namespace onggi::screens {
namespace {

class Shelf : public testing::TestWithParam<vec2> {
  protected:
    // The largest part of a card's height, in its written lines, that lies between two lines or below the
    // last.
    static float most_empty(const Composition& screen, const Target& card) {
        std::vector<ui::Rect> lines;
        for (const Writing& text : screen.writings)
            if (card.rect.contains(text.rect.centre())) lines.push_back(text.rect);
        EXPECT_GE(lines.size(), 2U);
        std::ranges::sort(lines, {}, &ui::Rect::y);
        float from = card.rect.y;
        float empty = 0.0F;
        for (const ui::Rect& line : lines) {
            empty = std::max(empty, line.y - from);
            from = line.bottom();
        }
        return std::max(empty, card.rect.bottom() - from) / screen.px_per_u;
    }
};

TEST_P(Shelf, HasCardsAsHighAsTheirWords) {
    constexpr float kMostEmptyU = 34.0F;  // a line
    ui::Painter painter;
    PaintingStore store(painter);
    for (const std::string language : {"en", "ko", "ar", "de"}) {
        for (const SampleView& sample : sample_views({.width_px = static_cast<int>(GetParam().x),
                                        .height_px = static_cast<int>(GetParam().y),
                                        .language = language})) {
            if (!sample.name.starts_with("choose")) continue;
            const Composition screen = visit::compose(*sample.view, painter, store);
            int cards = 0;
            for (const Target& target : screen.targets) {
                if (target.button != kiosk::Button::kFree && target.button != kiosk::Button::kTarget)
                    continue;
                EXPECT_LT(most_empty(screen, target), kMostEmptyU) << language << " " << target.name;
                ++cards;
            }
            EXPECT_GE(cards, 3);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(OfEveryShape, Shelf,
                         testing::Values(vec2(1280, 720), vec2(1024, 768), vec2(720, 1280)));

}  // namespace
}  // namespace onggi::screens

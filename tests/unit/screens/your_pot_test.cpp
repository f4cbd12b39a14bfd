// The screen of the finished pot: the visitor's pot is the largest thing on it, whatever museum's pot stands
// beside it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "game/visit/steps.h"
#include "tests/unit/screens/sample_views.h"

namespace onggi::screens {
namespace {

struct Thrown {
    const char* name;
    pot::Section shape;
};

// Pots as visitors leave them, from a small cup to a bottle.
std::vector<Thrown> thrown_pots() {
    return {{"a small cup", pot::hollowed({{27, 0}, {30, 30}, {31, 55}}, 6.0F, 9.0F)},
            {"a thick tube", pot::hollowed({{52, 0}, {50, 40}, {48, 96}}, 19.0F, 12.0F)},
            {"a squat jar", pot::hollowed({{44, 0}, {58, 40}, {55, 80}, {50, 92}}, 8.0F, 10.0F)},
            {"a bottle", pot::hollowed({{40, 0}, {60, 70}, {30, 150}, {20, 230}, {26, 250}}, 6.0F, 9.0F)}};
}

pot::Section vat() {
    return pot::hollowed({{210, 0}, {340, 350}, {380, 600}, {300, 900}, {310, 1015}}, 14.0F, 20.0F);
}

std::shared_ptr<const View> view_of(const SampleRequest& request, const Thrown& thrown, bool beside_vat) {
    for (const SampleView& sample : sample_views(request)) {
        if (sample.name != "your-pot") continue;
        FiredPot pot = *sample.view->pot;
        pot.shape = thrown.shape;
        pot.height_mm = double{thrown.shape.height_mm()};
        Exhibit relative = *pot.relative;
        if (beside_vat) {
            relative.shape = vat();
            relative.height_mm = 1015.0;
        } else {
            relative.shape = thrown.shape;
            relative.height_mm = pot.height_mm;
        }
        pot.relative = std::make_shared<const Exhibit>(std::move(relative));
        View view = *sample.view;
        view.pot = std::make_shared<const FiredPot>(std::move(pot));
        return std::make_shared<const View>(std::move(view));
    }
    return nullptr;
}

bool is_written(const Composition& screen, const std::string& words) {
    return std::any_of(screen.writings.begin(), screen.writings.end(),
                       [&](const Writing& text) { return text.words.find(words) != std::string::npos; });
}

class YourPot : public testing::Test {
  protected:
    Composition composed(const View& view) { return visit::compose(view, painter_, store_); }

    ui::Painter painter_;
    PaintingStore store_{painter_, PaintingStore::Paints::kNothing};
};

TEST_F(YourPot, IsAThirdOfThePicturesHeightBesideAnyMuseumPot) {
    constexpr std::pair<int, int> kSizes[]{{1280, 720}, {1920, 1080}, {1024, 768}, {720, 1280}};
    for (const auto& [width, height] : kSizes) {
        for (const bool reach : {false, true}) {
            for (const bool beside_vat : {false, true}) {
                for (const Thrown& thrown : thrown_pots()) {
                    SCOPED_TRACE(fmt::format("{} at {} x {}, reach {}, vat {}", thrown.name, width, height,
                                             reach, beside_vat));
                    const auto view =
                        view_of({.width_px = width, .height_px = height, .reach = reach}, thrown, beside_vat);
                    ASSERT_TRUE(view);
                    const Composition screen = composed(*view);
                    ASSERT_EQ(screen.pots.size(), 2U);
                    const ui::Rect& own = screen.pots[0];
                    const ui::Rect& museums = screen.pots[1];
                    EXPECT_GE(own.height, screen.bounds.height / 3.0F);
                    EXPECT_LE(museums.height, own.height);
                    EXPECT_GE(std::max(museums.width, museums.height), 90.0F) << "large enough to be seen";
                    const ui::Rect shared = overlap(own, museums);
                    EXPECT_FALSE(shared.width > 0.0F && shared.height > 0.0F);
                }
            }
        }
    }
}

TEST_F(YourPot, TellsHowTallTheMuseumPotReallyIsUnlessBothAreAtOneScale) {
    const Thrown tube = thrown_pots()[1];
    const Composition beside_vat = composed(*view_of({}, tube, true));
    EXPECT_TRUE(is_written(beside_vat, "really 10.6 times as tall"));
    EXPECT_FALSE(is_written(beside_vat, "both at one scale"));
    const Thrown cup{"a cup as small as its model", thrown_pots()[0].shape};
    FiredPot pot = *view_of({}, cup, false)->pot;
    Exhibit half = *pot.relative;
    half.shape = pot::hollowed({{8, 0}, {9, 15}, {10, 24}}, 2.0F, 3.0F);
    half.height_mm = 24.0;
    pot.relative = std::make_shared<const Exhibit>(half);
    View view = *view_of({}, cup, false);
    view.pot = std::make_shared<const FiredPot>(std::move(pot));
    EXPECT_TRUE(is_written(composed(view), "both at one scale"));
}

TEST(Firing, SaysThatAPotShrinksOnlyWhileItDries) {
    ui::Painter painter;
    PaintingStore store(painter, PaintingStore::Paints::kNothing);
    for (const SampleView& sample : sample_views({})) {
        if (!sample.name.starts_with("firing-")) continue;
        EXPECT_EQ(is_written(visit::compose(*sample.view, painter, store), "It shrinks"),
                  sample.view->state.firing == kiosk::FiringStage::kDry)
            << sample.name;
    }
}

TEST_F(YourPot, TurnsInTheLight) {
    ui::Painter painter;
    PaintingStore store(painter);
    const Composition screen =
        visit::compose(*view_of({.width_px = 320, .height_px = 180}, thrown_pots()[1], true), painter, store);
    std::vector<ui::Rect> turning;
    for (const Item& item : screen.items)
        if (item.turning) turning.push_back(item.rect);
    ASSERT_EQ(turning.size(), 1U);
    EXPECT_NEAR(turning[0].x, screen.pots[0].x, 0.01F) << "the visitor's, not the museum's";
}

TEST_F(YourPot, IsScoredAgainstThePotThatWasChosen) {
    const SampleRequest request;
    for (const SampleView& sample : sample_views(request)) {
        if (sample.name == "your-pot-after") {
            EXPECT_TRUE(is_written(composed(*sample.view), "off its outline"));
        }
        if (sample.name == "your-pot") {
            EXPECT_FALSE(is_written(composed(*sample.view), "off its outline"));
        }
    }
}

}  // namespace
}  // namespace onggi::screens

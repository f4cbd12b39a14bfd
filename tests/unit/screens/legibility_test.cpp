// How large words are where the settings put the visitor's eyes.
#include "game/screens/page/legibility.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "game/visit/steps.h"
#include "tests/unit/screens/sample_views.h"

namespace onggi::screens {
namespace {

struct Panel {
    int width_px;
    int height_px;
    double diagonal_inch;
    double distance_mm;
};

double smallest_degrees(const Panel& panel) {
    return smallest_text_degrees(panel.width_px, panel.height_px,
                                 px_per_mm(panel.width_px, panel.height_px, panel.diagonal_inch),
                                 panel.distance_mm);
}

// Composes the screens of these names for that panel.
std::vector<Composition> composed(const std::vector<std::string>& names, const Panel& panel) {
    ui::Painter painter;
    PaintingStore store(painter);
    std::vector<Composition> screens;
    for (const SampleView& sample : sample_views({panel.width_px, panel.height_px, "en", 1})) {
        if (std::find(names.begin(), names.end(), sample.name) == names.end()) continue;
        View view = *sample.view;
        view.px_per_mm = px_per_mm(panel.width_px, panel.height_px, panel.diagonal_inch);
        view.distance_mm = panel.distance_mm;
        screens.push_back(visit::compose(view, painter, store));
    }
    EXPECT_EQ(screens.size(), names.size());
    return screens;
}

TEST(Legibility, FindsTheDesignedPanelJustLargeEnough) {
    EXPECT_NEAR(px_per_mm(1920, 1080, 24.0), 3.613, 0.001);
    EXPECT_NEAR(smallest_degrees({1920, 1080, 24.0, 600.0}), 0.74, 0.005) << "26 u in Noto";
    EXPECT_EQ(legible_scale(0.4151, 600.0), 1.0F);
}

TEST(Legibility, DependsOnThePanelAndTheDistanceAndNotOnThePixels) {
    EXPECT_NEAR(smallest_degrees({1280, 720, 24.0, 600.0}), smallest_degrees({3840, 2160, 24.0, 600.0}),
                1e-6);
    EXPECT_NEAR(smallest_degrees({1920, 1080, 32.0, 800.0}), smallest_degrees({1920, 1080, 24.0, 600.0}),
                1e-6);
    EXPECT_LT(smallest_degrees({1920, 1080, 24.0, 900.0}), kLeastCapitalDegrees);
    EXPECT_GT(smallest_degrees({1080, 1920, 32.0, 600.0}), kLeastCapitalDegrees);
    EXPECT_NEAR(legible_scale(0.4151, 1000.0) / legible_scale(0.4151, 800.0), 1.25F, 1e-4F)
        << "larger in proportion to the distance";
    EXPECT_EQ(legible_scale(0.4151, 5000.0), 2.0F) << "beyond it no box holds a word";
    EXPECT_EQ(legible_scale(0.4151, 200.0), 1.0F) << "never smaller than designed";
}

TEST(Legibility, IsKeptByEveryWordAtTheDistanceForWhichThePanelIsLargeEnough) {
    for (const Panel& panel : {Panel{1280, 720, 24.0, 600.0}, Panel{1280, 720, 32.0, 800.0}}) {
        for (const Composition& screen :
             composed({"attract", "choose", "throw-1", "warning-thin", "idle"}, panel)) {
            ASSERT_FALSE(screen.writings.empty());
            for (const Writing& text : screen.writings) {
                EXPECT_GE(capital_degrees(double{text.size}, double{screen.mm_per_u}, panel.distance_mm),
                          kLeastCapitalDegrees)
                    << text.words;
            }
        }
    }
}

TEST(Legibility, EnlargesWordsWithTheDistanceUpToTheirBoxes) {
    const std::vector<std::string> names{"attract", "choose", "idle", "fault"};
    const Panel far{1280, 720, 24.0, 800.0};
    const std::vector<Composition> before = composed(names, {1280, 720, 24.0, 600.0});
    const std::vector<Composition> after = composed(names, far);
    ASSERT_EQ(before.size(), after.size());
    int grown = 0;
    int legible = 0;
    int all = 0;
    for (std::size_t screen = 0; screen < before.size(); ++screen) {
        ASSERT_EQ(before[screen].writings.size(), after[screen].writings.size());
        for (std::size_t i = 0; i < after[screen].writings.size(); ++i) {
            const Writing& text = after[screen].writings[i];
            const float size = before[screen].writings[i].size;
            EXPECT_GE(text.size, size - 0.01F) << text.words;
            EXPECT_FALSE(text.too_wide) << text.words;
            grown += text.size > size + 0.01F ? 1 : 0;
            legible += capital_degrees(double{text.size}, double{after[screen].mm_per_u}, far.distance_mm) >=
                               kLeastCapitalDegrees
                           ? 1
                           : 0;
            ++all;
        }
    }
    EXPECT_GT(grown * 2, all) << grown << " of " << all << " writings";
    // Texts whose box has a fixed size stay small; the program reports that at its start.
    EXPECT_GT(legible * 3, all) << legible << " of " << all << " writings";
}

}  // namespace
}  // namespace onggi::screens

// With reduced motion nothing moves by itself on any screen, and screens change by a short fade. Checked by
// the stage's output at successive times.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "game/screens/stage.h"
#include "game/visit/steps.h"
#include "tests/unit/screens/sample_views.h"

namespace onggi::screens {
namespace {

using Places = std::set<std::pair<float, float>>;

class LessMotion : public testing::Test {
  protected:
    LessMotion() {
        for (int i = 0; i <= 10; ++i) {
            band_.upper.push_back({200.0F + 10.0F * static_cast<float>(i), 60.0F});
            band_.lower.push_back({200.0F + 10.0F * static_cast<float>(i), 80.0F});
        }
    }
    std::vector<std::shared_ptr<const Composed>> screens(bool still) {
        std::vector<std::shared_ptr<const Composed>> all;
        for (const SampleView& sample :
             sample_views({.width_px = 320, .height_px = 180, .still = still, .staff = false}))
            all.push_back(std::make_shared<const Composed>(
                Composed{sample.view, visit::compose(*sample.view, painter_, store_)}));
        return all;
    }
    const ui::DrawList& draw(Stage& stage, double now_s) const {
        return stage.draw({.now_s = now_s, .band = &band_});
    }
    // The number of screens that still change after their transition.
    int moving(bool still) {
        int count = 0;
        for (const auto& screen : screens(still)) {
            Stage stage;
            stage.take(screen, 0.0);
            for (double now_s = 0.0; now_s <= 1.0; now_s += 0.05)
                static_cast<void>(draw(stage, now_s));
            const std::uint64_t first = draw(stage, 1.0).hash();
            bool moves = false;
            for (const double now_s : {1.05, 1.3, 2.2, 3.7, 5.15})
                moves = moves || draw(stage, now_s).hash() != first;
            count += moves ? 1 : 0;
        }
        return count;
    }
    static Places places(const ui::DrawList& list) {
        Places all;
        for (const ui::Vertex& vertex : list.vertices())
            all.emplace(vertex.position_px.x, vertex.position_px.y);
        return all;
    }
    // The number of transitions that draw something at a position where neither screen has it.
    int sliding(bool still) {
        const auto all = screens(still);
        int count = 0;
        for (std::size_t i = 1; i < all.size(); ++i) {
            Stage stage;
            const auto settled = [&](double from_s) {
                for (double now_s = from_s; now_s < from_s + 1.0; now_s += 0.05)
                    static_cast<void>(draw(stage, now_s));
                return places(draw(stage, from_s + 1.0));
            };
            stage.take(all[i - 1], 0.0);
            Places known = settled(0.0);
            stage.take(all[i], 2.0);
            const Places between = places(draw(stage, 2.0 + 0.04));
            const std::uint64_t soon = draw(stage, 2.0 + 0.121).hash();
            const Places after = settled(2.2);
            if (still) {
                EXPECT_EQ(soon, draw(stage, 3.2).hash()) << i << ": later than 120 ms";
            }
            known.insert(after.begin(), after.end());
            count += std::includes(known.begin(), known.end(), between.begin(), between.end()) ? 0 : 1;
        }
        return count;
    }

    ui::Painter painter_;
    PaintingStore store_{painter_};
    Band band_;
};

TEST_F(LessMotion, LeavesEveryScreenStill) {
    EXPECT_GT(moving(false), 10) << "what a visitor sees who did not ask for it";
    EXPECT_EQ(moving(true), 0);
}

TEST_F(LessMotion, HasNoSlidingBetweenScreens) {
    EXPECT_GT(sliding(false), 10) << "what a visitor sees who did not ask for it";
    EXPECT_EQ(sliding(true), 0);
}

}  // namespace
}  // namespace onggi::screens

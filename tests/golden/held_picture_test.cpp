// The live picture copies only what a target does not show already: what was drawn there before must be gone.
#include <gtest/gtest.h>

#include <cstdlib>

#include "engine/render/renderer.h"
#include "engine/vk/offscreen.h"
#include "game/wheel/workshop_scene.h"
#include "tests/golden/drawing_test.h"
#include "tests/golden/golden_scenes.h"

namespace onggi::golden {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 360;

class HeldPicture : public DrawingTest {
  protected:
    void SetUp() override {
        DrawingTest::SetUp();
        opened_ = wheel::open_scene({}, kWidth, kHeight);
        ASSERT_EQ(opened_.lack, "");
        for (const GoldenScene& scene : golden_scenes()) {
            if (scene.name == "pulling") pulling_ = scene;
        }
        ASSERT_FALSE(pulling_.name.empty());
    }
    [[nodiscard]] std::unique_ptr<render::Renderer> renderer() const {
        return render::Renderer::create(*device_, render::live_desc(vk::Offscreen::kFormat, true, kHeight))
            .value();
    }
    [[nodiscard]] std::unique_ptr<vk::Offscreen> target() const {
        return vk::Offscreen::create(*device_, {kWidth, kHeight}).value();
    }
    // The hand somewhere up the pot, and a box of the overlay somewhere across the picture.
    void draw(render::Renderer& renderer, vk::Offscreen& target, double lift_mm, float box_px) {
        GoldenScene shown = pulling_;
        shown.tool_position_mm.y += lift_mm;
        ui::DrawList list;
        list.add_box({.x = box_px, .y = 20.5F, .width = 90.0F, .height = 33.0F}, {.r = 1.0F, .a = 0.7F});
        const render::Overlay overlay{.list = &list, .atlas_side_px = 64};
        const auto drawn =
            renderer.draw(opened_.scene->apply(shown.pot(), kWidth, kHeight), target, &overlay);
        ASSERT_TRUE(drawn && *drawn);
        ASSERT_TRUE(target.wait());  // a renderer has one frame on its way
    }
    static int furthest(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
        int worst = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            worst = std::max(worst, std::abs(int{a[i]} - int{b[i]}));
        return worst;
    }

    wheel::OpenedScene opened_;
    GoldenScene pulling_;
};

// Far enough for the layers to have been read back.
constexpr int kFrames = 12;
// A texel of the shadow mask may stay one step of 255 from where it should be: of light, of which dark clay
// shows two in the picture.
constexpr int kMaskStep = 2;

TEST_F(HeldPicture, ShowsNothingOfTheFramesBefore) {
    auto long_used = renderer();
    auto held = target();
    for (int frame = 0; frame < kFrames; ++frame)
        draw(*long_used, *held, 30.0 - 4.0 * frame, 500.0F - 40.0F * static_cast<float>(frame));
    draw(*long_used, *held, 0.0, 300.0F);
    auto fresh = renderer();
    auto other = target();
    for (int frame = 0; frame < 3; ++frame)
        draw(*fresh, *other, 0.0, 300.0F);
    EXPECT_LE(furthest(held->read_back().value(), other->read_back().value()), kMaskStep);
}

TEST_F(HeldPicture, TakesNothingForGrantedWhereAnotherHasDrawn) {
    auto one = renderer();
    auto another = renderer();
    auto shared = target();
    auto own = target();
    for (int frame = 0; frame < kFrames; ++frame) {
        draw(*one, *shared, 20.0, 30.0F);
        draw(*another, *shared, -20.0, 330.0F);
    }
    for (int frame = 0; frame < 3; ++frame)
        draw(*another, *own, -20.0, 330.0F);
    EXPECT_LE(furthest(shared->read_back().value(), own->read_back().value()), kMaskStep);
}

TEST_F(HeldPicture, ShowsEachOfTwoTargetsWhole) {
    auto drawn = renderer();
    auto left = target();
    auto right = target();
    for (int frame = 0; frame < kFrames; ++frame) {
        draw(*drawn, *left, 20.0 - frame, 30.0F);
        draw(*drawn, *right, 20.0 - frame, 30.0F);
    }
    EXPECT_EQ(furthest(left->read_back().value(), right->read_back().value()), 0);
}

}  // namespace
}  // namespace onggi::golden

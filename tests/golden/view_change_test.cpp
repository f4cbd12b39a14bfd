// A cross-fade from the last picture of one view to another view: both backends show exactly the mix. The CPU
// backend renders the new view's static layers beside frames of the old view.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "engine/render/quality.h"
#include "engine/render/renderer.h"
#include "engine/vk/offscreen.h"
#include "game/wheel/wheel_scene.h"
#include "tests/golden/alike.h"
#include "tests/golden/golden_scenes.h"
#include "tests/support/validated_device.h"

namespace onggi::golden {
namespace {

constexpr int kMostFramesToMake = 12;
using Pixels = std::vector<std::uint8_t>;

// The difference of a picture from the mix of two others, levels of 255.
int off_the_mix(const Pixels& shown, const Pixels& from, const Pixels& to, float fraction) {
    int worst = 0;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const float mixed =
            static_cast<float>(from[i]) * (1.0F - fraction) + static_cast<float>(to[i]) * fraction;
        worst = std::max(worst, std::abs(int{shown[i]} - static_cast<int>(std::lround(mixed))));
    }
    return worst;
}

class ViewChangeTest : public support::ValidatedDevice {
  protected:
    void SetUp() override {
        support::ValidatedDevice::SetUp();
        shown_ = scene_named("pulling");
        opened_ = wheel::open_scene({}, kWidth, kHeight);
        ASSERT_EQ(opened_.lack, "");
        opened_.scene->look_at(wheel::View::kThrowing);
        opened_.scene->apply(shown_.shown(*opened_.scene), kWidth, kHeight);
        fading_ = make();
        for (int frame = 0; frame < 3; ++frame)
            next();
    }
    void TearDown() override {
        fading_ = {};
        support::ValidatedDevice::TearDown();
    }

    struct Drawn {
        std::unique_ptr<render::Renderer> renderer;
        std::unique_ptr<vk::Offscreen> target;
    };
    [[nodiscard]] Drawn make() const {
        const render::RendererDesc desc = render::quality_desc(step_, vk::Offscreen::kFormat, kHeight);
        return {render::Renderer::create(*device_, desc).value(),
                vk::Offscreen::create(*device_, {kWidth, kHeight}).value()};
    }
    static Pixels draw(Drawn& into, const render::Scene& scene, const render::Overlay* overlay = nullptr) {
        const auto drawn = into.renderer->draw(scene, *into.target, overlay);
        EXPECT_TRUE(drawn && *drawn);
        return into.target->read_back().value();
    }
    // Draws the next frame: the hand moves, and a finished view is shown.
    void next(const render::Overlay* overlay = nullptr) {
        shown_.tool_position_mm.y += 1.0;
        scene_ = opened_.scene->apply(shown_.shown(*opened_.scene), kWidth, kHeight, kFrameS);
        picture_ = draw(fading_, scene_, overlay);
        if (fading_.renderer->stats().next_view_ready) opened_.scene->next_view_is_ready();
    }
    // Draws frames until the camera changes. Keeps the last picture before that.
    void go_to(wheel::View view, const render::Overlay* overlay = nullptr) {
        opened_.scene->look_at(view);
        const render::Camera before = scene_.camera;
        for (int frame = 0; frame < kMostFramesToMake && scene_.camera == before; ++frame) {
            last_ = picture_;
            next(overlay);
        }
        ASSERT_FALSE(scene_.camera == before);
    }
    // This frame's scene drawn without any view change.
    [[nodiscard]] Pixels alone() const {
        render::Scene scene = scene_;
        scene.fade_in.reset();
        scene.next_view.reset();
        Drawn fresh = make();
        return draw(fresh, scene);
    }

    render::QualityStep step_ = render::QualityStep::kOneCore;
    GoldenScene shown_;
    wheel::OpenedScene opened_;
    Drawn fading_;
    render::Scene scene_;
    Pixels picture_;
    Pixels last_;
};

// With the CPU backend, and with the Vulkan one at full and at half size.
class ViewChange : public ViewChangeTest, public testing::WithParamInterface<render::QualityStep> {
  protected:
    void SetUp() override {
        step_ = GetParam();
        ViewChangeTest::SetUp();
    }
    [[nodiscard]] bool keeps_what_stands_still() const { return step_ == render::QualityStep::kOneCore; }
};
INSTANTIATE_TEST_SUITE_P(On, ViewChange,
                         testing::Values(render::QualityStep::kOneCore, render::QualityStep::kDiscreteGpu,
                                         render::QualityStep::kSlowestGpu),
                         [](const auto& tested) {
                             std::string name(render::quality_name(tested.param));
                             std::replace(name.begin(), name.end(), ' ', '_');
                             return name;
                         });

// CPU backend only.
class KeptViewChange : public ViewChangeTest {};

TEST_F(KeptViewChange, IsMadeInPartsWhileTheViewBeforeGoesOn) {
    const render::Camera before = scene_.camera;
    opened_.scene->look_at(wheel::View::kLookingIn);
    int frames = 0;
    for (;; ++frames) {
        ASSERT_LT(frames, kMostFramesToMake);
        next();
        if (!(scene_.camera == before)) break;
        ASSERT_TRUE(scene_.next_view.has_value());
        EXPECT_FALSE(scene_.fade_in.has_value());
        EXPECT_LE(apart(picture_, alone(), 0).worst, kMaskStep) << frames;
    }
    EXPECT_GT(frames, 3) << "all at once";
    EXPECT_FALSE(fading_.renderer->stats().still_life_drawn) << "it was to be there";
    EXPECT_TRUE(scene_.fade_in.has_value());
}

TEST_P(ViewChange, MixesTheLastPictureOfTheViewBeforeWithEachOfTheNext) {
    go_to(wheel::View::kLookingIn);
    float before = 0.0F;
    int frames = 0;
    for (; scene_.fade_in; next(), ++frames) {
        ASSERT_LT(frames, 20);
        EXPECT_GT(*scene_.fade_in, before);
        before = *scene_.fade_in;
        EXPECT_LE(off_the_mix(picture_, last_, alone(), before), kMaskStep) << before;
    }
    EXPECT_EQ(frames, 14) << "a quarter of a second, and the whole picture";
    EXPECT_LE(apart(picture_, alone(), 0).worst, kMaskStep);
    EXPECT_GT(apart(picture_, last_, 20).beyond, kWidth * kHeight / 4) << "it is another view";
}

TEST_P(ViewChange, EndsItsFadeBeforeItIsCalledBack) {
    go_to(wheel::View::kLookingIn);
    const render::Camera there = scene_.camera;
    opened_.scene->look_at(wheel::View::kThrowing);
    for (; scene_.fade_in; next())
        EXPECT_EQ(scene_.camera, there);
    go_to(wheel::View::kThrowing);
    ASSERT_TRUE(scene_.fade_in.has_value());
    EXPECT_LE(off_the_mix(picture_, last_, alone(), *scene_.fade_in), kMaskStep);
}

// After the size has changed and changed back, kept layers are invalid.
TEST_P(ViewChange, IsRenderedAgainAfterOtherSizes) {
    go_to(wheel::View::kLookingIn);
    while (scene_.fade_in)
        next();
    const auto small = vk::Offscreen::create(*device_, {320, 180}).value();
    ASSERT_TRUE(fading_.renderer->draw(scene_, *small).value());
    ASSERT_TRUE(small->wait());
    go_to(wheel::View::kThrowing);
    while (scene_.fade_in)
        next();
    EXPECT_LE(apart(picture_, alone(), 0).worst, kMaskStep);
}

// The overlay over the last picture must not be part of the fade.
TEST_P(ViewChange, LeavesNoTraceOfTheOverlay) {
    ui::DrawList list;
    list.add_box({.x = 200.0F, .y = 90.0F, .width = 240.0F, .height = 180.0F}, {.r = 1.0F, .a = 0.8F});
    const render::Overlay box{.list = &list, .atlas_side_px = 64};
    // Draws the same scenes without any overlay.
    Drawn bare = make();
    opened_.scene->look_at(wheel::View::kLookingIn);
    for (int frame = 0; !scene_.fade_in; ++frame) {
        ASSERT_LT(frame, kMostFramesToMake);
        next(&box);
        const Pixels without = draw(bare, scene_);
        EXPECT_GT(apart(picture_, without, 20).beyond, 20000) << "the box is seen";
    }
    next();
    EXPECT_LE(apart(picture_, draw(bare, scene_), 0).worst, kMaskStep);
}

TEST_P(ViewChange, IsCutWithReducedMotionWhenItIsReady) {
    opened_.scene->move_less(true);
    go_to(wheel::View::kLookingIn);
    EXPECT_NE(fading_.renderer->stats().still_life_drawn, keeps_what_stands_still());
    EXPECT_FALSE(scene_.fade_in.has_value());
    EXPECT_LE(apart(picture_, alone(), 0).worst, kMaskStep);
}

// A jump leaves no time to render the view beside frames; it appears at once.
TEST_P(ViewChange, IsCompleteAtOnceAfterAJump) {
    opened_.scene->look_at(wheel::View::kLookingIn);
    opened_.scene->jump();
    next();
    EXPECT_TRUE(fading_.renderer->stats().still_life_drawn);
    EXPECT_FALSE(scene_.fade_in.has_value());
    EXPECT_LE(apart(picture_, alone(), 0).worst, kMaskStep);
}

}  // namespace
}  // namespace onggi::golden

// While the camera moves the device bends the photographs: nothing jumps when it comes to stand.
#include <gtest/gtest.h>

#include <cstdlib>

#include "engine/render/quality.h"
#include "engine/render/renderer.h"
#include "engine/vk/offscreen.h"
#include "game/wheel/workshop_scene.h"
#include "tests/golden/drawing_test.h"
#include "tests/golden/golden_scenes.h"

namespace onggi::golden {
namespace {

constexpr double kFrameS = 1.0 / 60.0;

// Of all channels of all pixels, in levels of eight bits.
double mean_difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += std::abs(static_cast<int>(a[i]) - static_cast<int>(b[i]));
    return sum / static_cast<double>(a.size());
}

class Transitions : public DrawingTest {
  protected:
    void SetUp() override {
        DrawingTest::SetUp();
        shown_ = scene_named("pulling");
        shown_.width = 1280;  // as the photographs are
        shown_.height = 720;
        const render::RendererDesc desc =
            render::quality_desc(render::QualityStep::kSlowGpu, vk::Offscreen::kFormat, shown_.height);
        renderer_ = render::Renderer::create(*device_, desc).value();
        target_ = vk::Offscreen::create(*device_, {1280, 720}).value();
        opened_ = wheel::open_scene({}, shown_.width, shown_.height);
        ASSERT_EQ(opened_.lack, "");
        opened_.scene->look_at(wheel::View::kThrowing);
        opened_.scene->apply(shown_.shown(), shown_.width, shown_.height);
    }
    void TearDown() override {
        target_.reset();
        renderer_.reset();
        DrawingTest::TearDown();
    }
    std::vector<std::uint8_t> draw(const render::Scene& scene) {
        const auto drawn = renderer_->draw(scene, *target_);
        EXPECT_TRUE(drawn && *drawn);
        return target_->read_back().value();
    }

    GoldenScene shown_;
    std::unique_ptr<render::Renderer> renderer_;
    std::unique_ptr<vk::Offscreen> target_;
    wheel::OpenedScene opened_;
};

// What a level in the mean is: an edge of the wheel that moved by half a pixel, all round. A third of one is
// a shadow about the pot's foot that is clearly too dark.
TEST_F(Transitions, DoNotJumpByAQuarterOfALevelInTheMeanWhenTheCameraStands) {
    opened_.scene->look_at(wheel::View::kLookingIn);
    render::Scene last;
    bool stands = false;
    for (int frame = 1; frame < 600 && !stands; ++frame) {
        const render::Scene& scene =
            opened_.scene->apply(shown_.shown(), shown_.width, shown_.height, kFrameS);
        stands = !scene.transition.has_value();
        if (stands) {
            const std::vector<std::uint8_t> moving = draw(last);
            EXPECT_LT(mean_difference(moving, draw(scene)), 0.25);
        }
        last = scene;
    }
    EXPECT_TRUE(stands);
}

}  // namespace
}  // namespace onggi::golden

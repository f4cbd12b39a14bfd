// Photographs that come and go while the camera is on its way: a window that changes its shape drops those of
// the other shape, and nothing of them may stay behind where they are drawn from.
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/render/renderer.h"
#include "engine/vk/offscreen.h"
#include "tests/golden/drawing_test.h"

namespace onggi::golden {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 90;

render::Camera camera() {
    return {.eye_mm = {0.0F, 285.0F, 805.0F}, .target_mm = {0.0F, 82.0F, 0.0F}, .vertical_fov_rad = 0.471F};
}

// All of one grey, and as far away everywhere.
std::shared_ptr<const render::Background> grey_background(std::uint8_t level) {
    render::Background background;
    background.camera = camera();
    background.width_px = kWidth;
    background.height_px = kHeight;
    asset::Image grey{.width = kWidth, .height = kHeight, .rgba = {}};
    grey.rgba.assign(std::size_t{4} * kWidth * kHeight, level);
    const render::PhotographPair pair{grey, grey};
    background.photographs =
        std::make_shared<render::Photographs>(pair, [pair] { return Result<render::PhotographPair>(pair); });
    background.relief = {.columns = 2, .rows = 2, .depth_mm = {900.0F, 900.0F, 900.0F, 900.0F}};
    return std::make_shared<const render::Background>(std::move(background));
}

class Backgrounds : public DrawingTest {
  protected:
    void SetUp() override {
        DrawingTest::SetUp();
        make_renderer(render::Backend::kCpu);
        target_ = vk::Offscreen::create(*device_, {kWidth, kHeight}).value();
    }
    void make_renderer(render::Backend backend) {
        const render::RendererDesc desc = backend == render::Backend::kCpu
                                              ? render::live_desc(vk::Offscreen::kFormat, true, kHeight)
                                              : render::still_desc(vk::Offscreen::kFormat);
        renderer_ = render::Renderer::create(*device_, desc).value();
    }
    // The level in the picture's middle of a camera that stands at one background, or is on its way to
    // another.
    int drawn(const std::shared_ptr<const render::Background>& background,
              const std::shared_ptr<const render::Background>& towards) {
        render::Scene scene;
        scene.camera = camera();
        scene.background = background;
        scene.backgrounds_at_hand = {background};
        if (towards) {
            scene.backgrounds_at_hand.push_back(towards);
            scene.transition = render::CameraTransition{.towards = towards, .fraction = 1.0F};
        }
        const auto shown = renderer_->draw(scene, *target_);
        EXPECT_TRUE(shown && *shown) << (shown ? "" : shown.error().message);
        const std::vector<std::uint8_t> pixels = target_->read_back().value();
        return pixels[std::size_t{4} * (kHeight / 2 * kWidth + kWidth / 2)];
    }

    void TearDown() override {
        target_.reset();
        renderer_.reset();
        DrawingTest::TearDown();
    }

    std::unique_ptr<render::Renderer> renderer_;
    std::unique_ptr<vk::Offscreen> target_;
};

TEST_F(Backgrounds, AreShownAgainAfterTheyWereDropped) {
    make_renderer(render::Backend::kVulkan);
    const auto here = grey_background(60);
    const auto there = grey_background(200);
    const int first = drawn(here, there);
    const int before = drawn(here, nullptr);
    EXPECT_GT(first, before + 60);
    EXPECT_FALSE(here->photographs->are_here()) << "they lie on the device";
    EXPECT_FALSE(there->photographs->are_here());
    // What was freed is something else now.
    const auto other = grey_background(120);
    const int meanwhile = drawn(other, nullptr);
    EXPECT_GT(meanwhile, before + 30);
    EXPECT_LT(meanwhile, first - 30);
    EXPECT_EQ(drawn(here, there), first);
}

// One frame may come before the camera is told to stand.
TEST_F(Backgrounds, AreShownAsTheyAreToACameraOnItsWayWhereTheProcessorLaysThem) {
    const auto here = grey_background(60);
    const int alone = drawn(here, nullptr);
    EXPECT_EQ(drawn(here, grey_background(200)), alone);
    EXPECT_FALSE(here->photographs->are_here()) << "they lie where they are laid from";
}

// What the processor shaded in a large picture is no part of a small one that looks past the shadow.
TEST_F(Backgrounds, AreNotShadedByWhatWasSeenInALargerPicture) {
    render::Scene scene;
    scene.camera = camera();
    scene.background = grey_background(120);
    scene.backgrounds_at_hand = {scene.background};
    scene.spheres = {{.centre_mm = {0.0F, 60.0F, 0.0F}, .radius_mm = 40.0F}};
    for (int frame = 0; frame < 4; ++frame)
        ASSERT_TRUE(renderer_->draw(scene, *target_));
    ASSERT_TRUE(target_->wait());
    scene.camera.target_mm.x = 2000.0F;
    const auto small = vk::Offscreen::create(*device_, {48, 27}).value();
    const auto picture = [&] {
        EXPECT_TRUE(renderer_->draw(scene, *small));
        return small->read_back().value();
    };
    const std::vector<std::uint8_t> by_shaders = picture();
    for (int frame = 0; frame < 3; ++frame)
        EXPECT_EQ(picture(), by_shaders);
    EXPECT_TRUE(instance_->messages().empty()) << instance_->messages().front();
}

}  // namespace
}  // namespace onggi::golden

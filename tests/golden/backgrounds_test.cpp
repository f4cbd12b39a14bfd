// Loading and dropping photographs: a window that changes its aspect drops those of the other aspect, and
// nothing may keep drawing from them. Those that may be needed soon are loaded beside the frames.
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/render/renderer.h"
#include "engine/vk/offscreen.h"
#include "tests/golden/alike.h"
#include "tests/support/validated_device.h"

namespace onggi::golden {
namespace {

constexpr int kBackgroundWidth = 160;
constexpr int kBackgroundHeight = 90;

render::Camera camera() {
    return {.eye_mm = {0.0F, 285.0F, 805.0F}, .target_mm = {0.0F, 82.0F, 0.0F}, .vertical_fov_rad = 0.471F};
}

// All of one grey.
std::shared_ptr<const render::Background> grey_background(std::uint8_t level,
                                                          int height_px = kBackgroundHeight) {
    render::Background background;
    background.camera = camera();
    background.width_px = kBackgroundWidth;
    background.height_px = height_px;
    asset::Image grey{.width = kBackgroundWidth, .height = height_px, .rgba = {}};
    grey.rgba.assign(std::size_t{4} * kBackgroundWidth * static_cast<std::size_t>(height_px), level);
    const render::PhotographPair pair{grey, grey};
    background.photographs =
        std::make_shared<render::Photographs>(pair, [pair] { return Result<render::PhotographPair>(pair); });
    return std::make_shared<const render::Background>(std::move(background));
}

class Backgrounds : public support::ValidatedDevice {
  protected:
    void SetUp() override {
        support::ValidatedDevice::SetUp();
        make_renderer(render::Backend::kCpu);
        target_ = vk::Offscreen::create(*device_, {kBackgroundWidth, kBackgroundHeight}).value();
    }
    void make_renderer(render::Backend backend) {
        const render::RendererDesc desc =
            backend == render::Backend::kCpu
                ? render::live_desc(vk::Offscreen::kFormat, true, kBackgroundHeight)
                : render::still_desc(vk::Offscreen::kFormat);
        renderer_ = render::Renderer::create(*device_, desc).value();
    }
    // The level in the picture's middle, with another background at hand.
    int drawn(const std::shared_ptr<const render::Background>& background,
              const std::shared_ptr<const render::Background>& next = nullptr) {
        render::Scene scene;
        scene.camera = camera();
        scene.background = background;
        scene.backgrounds_at_hand = {background};
        if (next) {
            scene.backgrounds_at_hand.push_back(next);
            scene.next_view = render::NextView{.camera = camera(), .background = next};
        }
        const auto shown = renderer_->draw(scene, *target_);
        EXPECT_TRUE(shown && *shown) << (shown ? "" : shown.error().message);
        const std::vector<std::uint8_t> pixels = target_->read_back().value();
        return pixels[std::size_t{4} * (kBackgroundHeight / 2 * kBackgroundWidth + kBackgroundWidth / 2)];
    }

    void TearDown() override {
        target_.reset();
        renderer_.reset();
        support::ValidatedDevice::TearDown();
    }

    std::unique_ptr<render::Renderer> renderer_;
    std::unique_ptr<vk::Offscreen> target_;
};

TEST_F(Backgrounds, AreShownAgainAfterTheyWereDropped) {
    for (const render::Backend backend : {render::Backend::kVulkan, render::Backend::kCpu}) {
        make_renderer(backend);
        const auto here = grey_background(60);
        const int first = drawn(here);
        EXPECT_FALSE(here->photographs->are_here()) << "they lie where they are drawn from";
        // The freed memory has been reused.
        EXPECT_GT(drawn(grey_background(120)), first + 30);
        EXPECT_EQ(drawn(here), first);
    }
}

// One strip per frame: uploading a whole photograph in one frame would make it late.
TEST_F(Backgrounds, AreReadyWhenTheirLastRowIsOnTheDevice) {
    make_renderer(render::Backend::kVulkan);
    const auto here = grey_background(60);
    constexpr int kRows = 4000;  // 2.4 MB a photograph: two strips each
    const auto there = grey_background(200, kRows);
    const int alone = drawn(here);
    int frames = 0;
    do {
        ASSERT_LT(frames, 10);
        EXPECT_EQ(drawn(here, there), alone);
        ++frames;
        EXPECT_NE(renderer_->stats().next_view_ready, there->photographs->are_here());
    } while (!renderer_->stats().next_view_ready);
    EXPECT_EQ(frames, 4);
    EXPECT_GT(drawn(there), alone + 60);
}

// Shading of a large picture must not appear in a small one whose view excludes the shadow.
TEST_F(Backgrounds, AreNotShadedByALargerPicturesMask) {
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

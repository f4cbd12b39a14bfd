// The live picture is put together from cached layers, the still one is drawn whole: the same pot must look
// the same in both.
#include <gtest/gtest.h>

#include <cstdlib>

#include "engine/asset/image.h"
#include "engine/render/renderer.h"
#include "engine/vk/offscreen.h"
#include "game/wheel/wheel_scene.h"
#include "tests/golden/golden_scenes.h"

namespace onggi::golden {
namespace {

class RenderPaths : public testing::TestWithParam<GoldenScene> {
  protected:
    void SetUp() override {
        auto instance = vk::Instance::create({.validation = true});
        ASSERT_TRUE(instance) << instance.error().message;
        instance_ = std::move(*instance);
        auto chosen = vk::choose_device(*instance_, VK_NULL_HANDLE);
        ASSERT_TRUE(chosen) << chosen.error().message;
        auto device = vk::Device::create(*instance_, *chosen, false);
        ASSERT_TRUE(device) << device.error().message;
        device_ = std::move(*device);
    }
    void TearDown() override {
        device_.reset();
        for (const std::string& message : instance_->messages())
            ADD_FAILURE() << message;
    }

    // The last of some frames: with the cache, the still life is one frame old and the shadow another.
    asset::Image draw(const GoldenScene& scene, bool cached, int frames = 1) {
        render::RendererDesc desc = render::live_desc(vk::Offscreen::kFormat, true, scene.height);
        desc.cached = cached;
        auto renderer = render::Renderer::create(*device_, desc);
        auto target = vk::Offscreen::create(
            *device_, {static_cast<std::uint32_t>(scene.width), static_cast<std::uint32_t>(scene.height)});
        wheel::WheelScene wheel_scene;
        for (int frame = 0; frame < frames; ++frame) {
            // Something else first, so that what is left of it would show.
            GoldenScene shown = scene;
            if (frame + 1 < frames) std::fill(shown.radii_mm.begin(), shown.radii_mm.end(), 60.0F);
            const auto drawn =
                (*renderer)->draw(wheel_scene.apply(shown.pot(), scene.width, scene.height), **target);
            EXPECT_TRUE(drawn && *drawn);
            EXPECT_EQ((*renderer)->stats().still_life_drawn, !cached || frame == 0);
        }
        return {.width = scene.width, .height = scene.height, .rgba = (*target)->read_back().value()};
    }

    std::unique_ptr<vk::Instance> instance_;
    std::unique_ptr<vk::Device> device_;
};

TEST_P(RenderPaths, AgreeWithinTwoLevelsOfEightBits) {
    const asset::Image direct = draw(GetParam(), false);
    const asset::Image cached = draw(GetParam(), true, 3);
    ASSERT_EQ(direct.rgba.size(), cached.rgba.size());
    // Layers are rounded to eight bits before they are mixed, and the mask's coordinates to half floats: one
    // level each. More, on no pixel, is an edge that moved or a shadow that was cut off.
    int worst = 0;
    std::size_t worst_at = 0;
    for (std::size_t i = 0; i < direct.rgba.size(); ++i) {
        const int difference = std::abs(static_cast<int>(direct.rgba[i]) - static_cast<int>(cached.rgba[i]));
        if (difference > worst) {
            worst = difference;
            worst_at = i / 4;
        }
    }
    const auto width = static_cast<std::size_t>(direct.width);
    EXPECT_LE(worst, 2) << "at " << worst_at % width << ", " << worst_at / width;
}

INSTANTIATE_TEST_SUITE_P(OfThePot, RenderPaths, testing::ValuesIn(golden_scenes()),
                         [](const auto& tested) { return test_name(tested.param); });

}  // namespace
}  // namespace onggi::golden

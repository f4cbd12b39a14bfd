// The moving picture of every scene, kept layers and all, under the validation layer with synchronization
// validation: sizes that change with every frame, a moving camera, changing light, an overlay, and lost
// devices. There must be no message.
#include <gtest/gtest.h>

#include <array>

#include "engine/render/renderer.h"
#include "engine/vk/offscreen.h"
#include "game/wheel/live_view.h"
#include "game/wheel/wheel_scene.h"
#include "tests/golden/alike.h"
#include "tests/golden/golden_scenes.h"
#include "tests/support/test_backend.h"
#include "tests/support/validated_device.h"

namespace onggi::golden {
namespace {

wheel::View view_of(const GoldenScene& scene) {
    return scene.view == wheel::StillView::kLookingIn ? wheel::View::kLookingIn : wheel::View::kThrowing;
}

using support::ValidatedDevice;

TEST_F(ValidatedDevice, ReportsNothingForAnySceneWhileTheSizeChanges) {
    auto renderer =
        render::Renderer::create(*device_, render::live_desc(vk::Offscreen::kFormat, true, 240)).value();
    wheel::OpenedScene opened = wheel::open_scene({}, 320, 240);
    ASSERT_EQ(opened.lack, "");
    ui::DrawList list;
    list.add_box({10.0F, 10.0F, 60.0F, 20.0F}, ui::hex(0xF4ECE0, 0.5F));
    const render::Overlay overlay{.list = &list, .atlas_side_px = 64};
    constexpr std::array<VkExtent2D, 4> kSizes{{{320, 240}, {97, 161}, {17, 16}, {417, 235}}};
    std::size_t number = 0;
    for (const GoldenScene& scene : golden_scenes()) {
        opened.scene->look_at(view_of(scene));
        opened.scene->set_evening(number % 3 == 1 ? 1.0 : 0.0);
        opened.scene->sway(number % 5 == 4);
        wheel::Clay& clay = opened.scene->registry().get<wheel::Clay>(opened.scene->clay());
        clay.is_cut_open = clay.shows_load = scene.view == wheel::StillView::kCutaway;
        for (int size = 0; size < 2; ++size) {
            const VkExtent2D extent = kSizes[number++ % kSizes.size()];
            auto target = vk::Offscreen::create(*device_, extent).value();
            const auto width = static_cast<int>(extent.width);
            const auto height = static_cast<int>(extent.height);
            // With the same layers, with new ones, and with those that the CPU has read back.
            for (int frame = 0; frame < 4; ++frame) {
                const auto drawn =
                    renderer->draw(opened.scene->apply(scene.shown(*opened.scene), width, height, kFrameS),
                                   *target, &overlay);
                ASSERT_TRUE(drawn) << scene.name << ": " << drawn.error().message;
                EXPECT_TRUE(*drawn) << scene.name;
            }
            ASSERT_TRUE(target->wait());
        }
        ASSERT_TRUE(instance_->messages().empty()) << scene.name << ": " << instance_->messages().front();
    }
}

TEST(LivePicture, CausesNoMessageAfterEachDeviceLoss) {
    auto view = wheel::LiveView::open({.width = 200,
                                       .height = 150,
                                       .headless = true,
                                       .validation = true,
                                       .backend = test::backend_of_environment()});
    ASSERT_TRUE(view) << view.error().message;
    int lost = 0;
    int number = 0;
    for (const GoldenScene& scene : golden_scenes()) {
        const bool loses = number++ % 12 == 6;
        if (loses) {
            // Enough frames to count as a new failure, not a repeated one.
            for (int frame = 0; frame < 60; ++frame)
                ASSERT_TRUE((*view)->draw(scene.shown((*view)->scene()), kFrameS));
            (*view)->device_health().inject({.call = "vkQueueSubmit2", .result = VK_ERROR_DEVICE_LOST});
            ++lost;
        }
        (*view)->scene().look_at(view_of(scene));
        for (int frame = 0; frame < 2; ++frame) {
            const auto drawn =
                (*view)->draw(scene.shown((*view)->scene()), kFrameS);  // an error if the layer reports
            ASSERT_TRUE(drawn) << scene.name << ": " << drawn.error().message;
            EXPECT_TRUE(*drawn) << scene.name;
        }
        EXPECT_EQ((*view)->mended(), lost) << scene.name;
    }
    EXPECT_GE(lost, 2);
}

}  // namespace
}  // namespace onggi::golden

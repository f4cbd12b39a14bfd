// The moving picture at the GPU quality steps, four samples per pixel, on a driver other than Mesa's
// software: against approved pictures by SwiftShader, and through changes of view, size and time of day;
// under the validation layer with synchronization validation, without any message.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <memory>

#include "engine/render/quality.h"
#include "engine/render/renderer.h"
#include "engine/vk/offscreen.h"
#include "game/wheel/wheel_scene.h"
#include "tests/golden/alike.h"
#include "tests/golden/live_scenes.h"
#include "tests/support/image_gate.h"
#include "tests/support/places.h"
#include "tests/support/validated_device.h"

namespace onggi::golden {
namespace {

constexpr double kFrameS = 1.0 / 60.0;

render::RendererDesc gpu_desc(render::QualityStep step, int height_px) {
    return render::quality_desc(step, vk::Offscreen::kFormat, height_px);
}

class MovingPictures : public support::ValidatedDevice, public testing::WithParamInterface<LiveScene> {};

TEST_P(MovingPictures, EqualTheOnesThatWereLookedAt) {
    const GoldenScene shown = scene_named(GetParam().pot);
    const vk::DeviceDescription& driver = device_->description();
    const support::RenderInfo info{.driver = driver.driver,
                                   .version = driver.name,
                                   .driver_info = driver.driver_info,
                                   .state_hash = fmt::format("{:016x}", shown.hash())};
    support::GateOptions options = support::gate_options_from_environment();
    options.golden_folder = test::in_checkout("tests/golden/images/swiftshader");
    const asset::Image drawn =
        draw_live(*device_, GetParam(), gpu_desc(render::QualityStep::kIntegratedGpu, shown.height));
    EXPECT_TRUE(support::matches_golden(GetParam().name, drawn, info, options));
}

// Hands at work, a wall that is looked into, one that is cut and shows its load, a glazed one in the evening,
// all that an overlay draws, and one view on its way into another.
INSTANTIATE_TEST_SUITE_P(OfThePot, MovingPictures,
                         testing::Values(LiveScene{.name = "gpu-pulling", .pot = "pulling"},
                                         LiveScene{.name = "gpu-inside", .pot = "inside"},
                                         LiveScene{.name = "gpu-load", .pot = "load"},
                                         LiveScene{.name = "gpu-evening", .pot = "celadon", .evening = 1.0},
                                         LiveScene{
                                             .name = "gpu-overlay", .pot = "centring", .has_overlay = true},
                                         LiveScene{.name = "gpu-fading", .pot = "wide", .fades = true}),
                         [](const auto& tested) { return test_name({.name = tested.param.name}); });

class AStormOfSizes : public MovingPictures {};

TEST_F(AStormOfSizes, CausesNoValidationMessageOnAnyGpuStep) {
    wheel::OpenedScene opened = wheel::open_scene({}, 320, 240);
    ASSERT_EQ(opened.lack, "");
    constexpr std::array<VkExtent2D, 4> kSizes{{{320, 240}, {97, 161}, {17, 16}, {417, 235}}};
    const std::vector<GoldenScene>& scenes = golden_scenes();
    std::size_t number = 0;
    for (const render::QualityStep step :
         {render::QualityStep::kSlowestGpu, render::QualityStep::kSlowerGpu, render::QualityStep::kSlowGpu,
          render::QualityStep::kIntegratedGpu, render::QualityStep::kDiscreteGpu}) {
        auto renderer = render::Renderer::create(*device_, gpu_desc(step, 240)).value();
        SampleOverlay overlay;
        for (std::size_t scene = number % 3; scene < scenes.size(); scene += 3) {
            const GoldenScene& shown = scenes[scene];
            opened.scene->look_at(number % 2 == 0 ? wheel::View::kThrowing : wheel::View::kLookingIn);
            opened.scene->set_evening(number % 3 == 1 ? 1.0 : 0.0);
            opened.scene->sway(number % 5 == 4);
            const VkExtent2D extent = kSizes[number++ % kSizes.size()];
            auto target = vk::Offscreen::create(*device_, extent).value();
            for (int frame = 0; frame < 3; ++frame) {
                render::Overlay laid = overlay.next();
                laid.covers = frame == 2 && number % 4 == 0;
                const auto drawn = renderer->draw(
                    opened.scene->apply(shown.shown(*opened.scene), static_cast<int>(extent.width),
                                        static_cast<int>(extent.height), kFrameS),
                    *target, &laid);
                ASSERT_TRUE(drawn) << shown.name << ": " << drawn.error().message;
                EXPECT_TRUE(*drawn) << shown.name;
            }
            ASSERT_TRUE(target->wait());
        }
        ASSERT_TRUE(instance_->messages().empty())
            << render::quality_name(step) << ": " << instance_->messages().front();
    }
}

}  // namespace
}  // namespace onggi::golden

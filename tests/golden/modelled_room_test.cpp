// A modelled room, without photographs, as a GPU draws it: static objects render their shadows once.
#include <gtest/gtest.h>

#include "engine/render/quality.h"
#include "engine/render/renderer.h"
#include "engine/vk/offscreen.h"
#include "game/wheel/wheel_scene.h"
#include "tests/golden/alike.h"
#include "tests/golden/golden_scenes.h"
#include "tests/support/places.h"
#include "tests/support/validated_device.h"

namespace onggi::golden {
namespace {

constexpr int kRoomWidth = 320;
constexpr int kRoomHeight = 180;

class ModelledRoomTest : public support::ValidatedDevice {
  protected:
    void SetUp() override {
        support::ValidatedDevice::SetUp();
        opened_ = wheel::open_scene(test::in_checkout("assets/workshop/room.glb"), kRoomWidth, kRoomHeight);
        ASSERT_EQ(opened_.lack, "");
        target_ = vk::Offscreen::create(*device_, {kRoomWidth, kRoomHeight}).value();
    }
    void TearDown() override {
        target_.reset();
        support::ValidatedDevice::TearDown();
    }
    [[nodiscard]] std::unique_ptr<render::Renderer> renderer() const {
        return render::Renderer::create(*device_, render::quality_desc(render::QualityStep::kSlowestGpu,
                                                                       vk::Offscreen::kFormat, kRoomHeight))
            .value();
    }
    // The room in that light, and the pot on its wheel.
    std::vector<std::uint8_t> draw(render::Renderer& renderer, double evening) {
        opened_.scene->set_evening(evening);
        // By then the light has changed and the hands have arrived.
        constexpr double kSettledS = 5.0;
        static_cast<void>(
            opened_.scene->apply(shown_.shown(*opened_.scene), kRoomWidth, kRoomHeight, kSettledS));
        const render::Scene scene =
            opened_.scene->apply(shown_.shown(*opened_.scene), kRoomWidth, kRoomHeight, 0.0);
        const auto drawn = renderer.draw(scene, *target_, nullptr);
        EXPECT_TRUE(drawn && *drawn);
        return target_->read_back().value();
    }

    GoldenScene shown_ = scene_named("pulling");
    wheel::OpenedScene opened_;
    std::unique_ptr<vk::Offscreen> target_;
};

TEST_F(ModelledRoomTest, CastsItsShadowsOnceAndThePictureIsTheSame) {
    const auto keeps = renderer();
    const auto first = draw(*keeps, 0.0);
    const int first_draws = keeps->stats().work.draws;
    EXPECT_EQ(draw(*keeps, 0.0), first);
    EXPECT_LT(keeps->stats().work.draws, first_draws);
    const auto evening = draw(*keeps, 1.0);
    EXPECT_NE(evening, first);
    EXPECT_EQ(evening, draw(*renderer(), 1.0)) << "the shadows that were kept, and new ones";
}

}  // namespace
}  // namespace onggi::golden

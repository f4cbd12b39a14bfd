// Every scene against its stored picture; the same scene twice; and no message from the validation layer.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <utility>

#include "engine/vk/physical_device.h"
#include "game/wheel/still.h"
#include "tests/golden/golden_scenes.h"
#include "tests/support/image_gate.h"

namespace onggi::golden {
namespace {

// "Mesa 22.3.6 (LLVM 15.0.6)": a picture is exact within one version of both, so both are the version.
support::RenderInfo render_info(const GoldenScene& scene) {
    const auto devices = vk::describe_devices();
    if (!devices) return {};
    for (const vk::DeviceDescription& device : *devices) {
        if (!device.chosen) continue;
        EXPECT_TRUE(device.is_cpu()) << "golden pictures are drawn on the software device";
        return {.driver = device.driver,
                .version = device.driver_info,
                .driver_info = device.driver_info,
                .state_hash = fmt::format("{:016x}", scene.hash())};
    }
    return {};
}

// All pictures of one size share a renderer, because most of the work is common.
class Picture : public testing::TestWithParam<GoldenScene> {
  protected:
    static void TearDownTestSuite() {
        for (auto& [size, camera] : cameras()) {
            const auto closed = camera->close();
            EXPECT_TRUE(closed) << closed.error().message;
        }
        cameras().clear();
    }
    static Result<asset::Image> take(const GoldenScene& scene) {
        auto& camera = cameras()[{scene.width, scene.height}];
        if (!camera) {
            auto made = wheel::StillCamera::create(scene.width, scene.height, {.validation = true});
            if (!made) return made.error();
            camera = std::move(*made);
        }
        camera->forget();
        return camera->take(scene.shown(camera->scene()), scene.view);
    }

  private:
    static std::map<std::pair<int, int>, std::unique_ptr<wheel::StillCamera>>& cameras() {
        static std::map<std::pair<int, int>, std::unique_ptr<wheel::StillCamera>> all;
        return all;
    }
};

TEST_P(Picture, EqualsTheOneThatWasLookedAt) {
    const GoldenScene& scene = GetParam();
    const auto image = take(scene);
    ASSERT_TRUE(image) << image.error().message;
    EXPECT_TRUE(support::matches_golden(scene.name, *image, render_info(scene)));
}

INSTANTIATE_TEST_SUITE_P(OfThePot, Picture, testing::ValuesIn(golden_scenes()),
                         [](const auto& tested) { return test_name(tested.param); });

TEST(Still, IsTheSameToTheByteEveryTime) {
    const GoldenScene scene = golden_scenes().at(1);
    const auto first = scene.drawn_alone(320, 240, {});
    const auto second = scene.drawn_alone(320, 240, {});
    ASSERT_TRUE(first && second);
    EXPECT_EQ(first->rgba, second->rgba);
}

TEST(Still, TurnsItsStreaksWithTheWheel) {
    GoldenScene scene = golden_scenes().at(1);
    const auto before = scene.drawn_alone(320, 240, {});
    scene.wheel_direction = {-0.6, 0.8};
    const auto after = scene.drawn_alone(320, 240, {});
    ASSERT_TRUE(before && after);
    EXPECT_NE(before->rgba, after->rgba);
}

}  // namespace
}  // namespace onggi::golden

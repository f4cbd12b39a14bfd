// While the camera moves, the processor bends the photographs where it is the device: the same picture as the
// device's own, frame by frame, and nothing that jumps when the camera stands.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "engine/asset/image.h"
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

class BentPlates : public DrawingTest {
  protected:
    void SetUp() override {
        DrawingTest::SetUp();
        for (const GoldenScene& scene : golden_scenes()) {
            if (scene.name == "pulling") shown_ = scene;
        }
        ASSERT_EQ(shown_.name, "pulling");
        shown_.width = 1280;  // as the photographs are
        shown_.height = 720;
        by_host_ = picture_of(true);
        by_device_ = picture_of(false);
        opened_ = wheel::open_scene({}, shown_.width, shown_.height);
        ASSERT_EQ(opened_.lack, "");
        opened_.scene->look_at(wheel::View::kThrowing);
        opened_.scene->apply(shown_.pot(), shown_.width, shown_.height);
    }
    void TearDown() override {
        by_host_ = {};
        by_device_ = {};
        DrawingTest::TearDown();
    }

    struct Drawn {
        std::unique_ptr<render::Renderer> renderer;
        std::unique_ptr<vk::Offscreen> target;
    };
    Drawn picture_of(bool by_host, bool softens_glides = false) {
        render::RendererDesc desc = render::live_desc(vk::Offscreen::kFormat, true, shown_.height);
        desc.cached = by_host;
        desc.smooths_outlines = false;  // only the cached picture is smoothed
        desc.softens_glides = softens_glides;
        return {
            render::Renderer::create(*device_, desc).value(),
            vk::Offscreen::create(*device_, {static_cast<std::uint32_t>(shown_.width),
                                             static_cast<std::uint32_t>(shown_.height)})
                .value(),
        };
    }
    static std::vector<std::uint8_t> draw(Drawn& into, const render::Scene& scene) {
        const auto drawn = into.renderer->draw(scene, *into.target);
        EXPECT_TRUE(drawn && *drawn);
        return into.target->read_back().value();
    }
    const render::Scene& next() {
        return opened_.scene->apply(shown_.pot(), shown_.width, shown_.height, kFrameS);
    }

    GoldenScene shown_;
    Drawn by_host_;
    Drawn by_device_;
    wheel::OpenedScene opened_;
};

// Where both plates are mixed the device divides for every pixel, the processor for every corner.
TEST_F(BentPlates, AreWithinOneAndAHalfLevelsOfTheDevicesInTheMeanAndHalfALevelNearTheirPlaces) {
    opened_.scene->look_at(wheel::View::kLookingIn);
    int compared = 0;
    for (int frame = 1; frame <= 60; ++frame) {
        const render::Scene& scene = next();
        ASSERT_TRUE(scene.glide.has_value());
        if (frame % 10 != 0) continue;
        const bool is_near_a_place = scene.glide->share == 0.0F || scene.glide->share == 1.0F;
        EXPECT_LT(mean_difference(draw(by_host_, scene), draw(by_device_, scene)),
                  is_near_a_place ? 0.5 : 1.5)
            << "frame " << frame << ", share " << scene.glide->share;
        ++compared;
    }
    EXPECT_EQ(compared, 6);
}

TEST_F(BentPlates, AreWithinHalfALevelOfTheDevicesInTheEvening) {
    opened_.scene->set_evening(1.0);
    opened_.scene->apply(shown_.pot(), shown_.width, shown_.height);
    opened_.scene->look_at(wheel::View::kLookingIn);
    for (int frame = 1; frame < 10; ++frame)
        next();
    const render::Scene& scene = next();
    ASSERT_LT(scene.levels.key, 0.5F);
    EXPECT_LT(mean_difference(draw(by_host_, scene), draw(by_device_, scene)), 0.5);
}

TEST_F(BentPlates, AreCoarseWhileTheCameraGoesFastAndOnlyThen) {
    Drawn soft = picture_of(true, true);
    opened_.scene->look_at(wheel::View::kLookingIn);
    std::vector<double> differences;
    for (;;) {
        const render::Scene& scene = next();
        if (!scene.glide) break;
        differences.push_back(mean_difference(draw(soft, scene), draw(by_host_, scene)));
    }
    ASSERT_GT(differences.size(), 60U);
    // Where a frame is hardly further than the one before, every pixel is its own.
    for (const std::size_t at_end : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
        EXPECT_EQ(differences[at_end], 0.0);
        EXPECT_EQ(differences[differences.size() - 1 - at_end], 0.0);
    }
    const auto coarse =
        std::count_if(differences.begin(), differences.end(), [](double d) { return d > 0.0; });
    EXPECT_GT(coarse, static_cast<std::ptrdiff_t>(differences.size() / 2));
    EXPECT_LT(*std::max_element(differences.begin(), differences.end()), 1.1);
}

// What a level in the mean is: an edge of the wheel that moved by half a pixel, all round. A third of one is
// a shadow about the pot's foot that is clearly too dark.
TEST_F(BentPlates, DoNotJumpByAQuarterOfALevelInTheMeanWhenTheCameraStands) {
    opened_.scene->look_at(wheel::View::kLookingIn);
    render::Scene last;
    bool stands = false;
    for (int frame = 1; frame < 600 && !stands; ++frame) {
        const render::Scene& scene = next();
        stands = !scene.glide.has_value();
        if (stands) {
            for (Drawn* drawn : {&by_host_, &by_device_}) {
                const std::vector<std::uint8_t> moving = draw(*drawn, last);
                EXPECT_LT(mean_difference(moving, draw(*drawn, scene)), 0.25);
            }
        }
        last = scene;
    }
    EXPECT_TRUE(stands);
}

}  // namespace
}  // namespace onggi::golden

// The golden gate must reject real pictures with the smallest errors that matter.
#include <gtest/gtest.h>

#include <functional>

#include "engine/render/renderer.h"
#include "engine/vk/offscreen.h"
#include "game/wheel/wheel_scene.h"
#include "tests/golden/golden_scenes.h"
#include "tests/support/image_compare.h"
#include "tests/support/image_gate.h"
#include "tests/support/temporary_folder.h"

namespace onggi::golden {
namespace {

constexpr int kGateWidth = 640;
constexpr int kGateHeight = 480;

class Gate : public testing::Test {
  protected:
    void SetUp() override {
        opened_ = wheel::open_scene({}, kGateWidth, kGateHeight);
        options_.golden_folder = folder_ / "golden";
        options_.output_folder = folder_ / "out";
        options_.dirty_paths = [] { return Result<std::string>(std::string()); };
        options_.bless = {"vase"};
        ASSERT_TRUE(support::matches_golden("vase", draw(), info_, options_));
        options_.bless.clear();
    }

    // The jar on the wheel, after a change.
    asset::Image draw(const std::function<void(pot::Pot&)>& change_pot = {},
                      const std::function<void(render::Scene&)>& change_scene = {}, bool inside_out = false) {
        pot::Pot pot = studio_pot(jar());
        if (change_pot) change_pot(pot);
        const GoldenScene golden{.name = "vase", .pot = pot, .tool_shown = false};
        render::RendererDesc desc = render::still_desc(vk::Offscreen::kFormat);
        desc.inside_out = inside_out;
        auto renderer = render::Renderer::create(*drawn_by_.device, desc).value();
        auto target = vk::Offscreen::create(*drawn_by_.device, {kGateWidth, kGateHeight}).value();
        render::Scene scene = opened_.scene->apply(golden.shown(*opened_.scene), kGateWidth, kGateHeight);
        if (change_scene) change_scene(scene);
        EXPECT_TRUE(renderer->draw(scene, *target).value());
        return {.width = kGateWidth, .height = kGateHeight, .rgba = target->read_back().value()};
    }
    [[nodiscard]] testing::AssertionResult check(const asset::Image& image) const {
        return support::matches_golden("vase", image, info_, options_);
    }

    const support::RenderInfo info_{"llvmpipe", "1", "1", "0123456789abcdef"};
    test::TemporaryFolder folder_;
    support::GateOptions options_;
    vk::OffscreenDevice drawn_by_ = vk::OffscreenDevice::open().value();
    wheel::OpenedScene opened_;
};

TEST_F(Gate, PassesTheSamePotDrawnAgain) {
    EXPECT_TRUE(check(draw()));
}

TEST_F(Gate, SeesATwentiethOfAMillimetreOfRadius) {
    EXPECT_FALSE(check(draw([](pot::Pot& pot) {
        for (float& radius : pot.outer_mm)
            radius += 0.05F;
    })));
}

TEST_F(Gate, SeesOnePercentOfLight) {
    EXPECT_FALSE(check(draw({}, [](render::Scene& scene) { scene.key.radiance *= 0.99F; })));
    EXPECT_FALSE(check(draw({}, [](render::Scene& scene) {
        for (vec3& coefficient : *scene.irradiance)
            coefficient *= 0.99F;
        scene.key.radiance *= 0.99F;
    })));
}

TEST_F(Gate, SeesAPictureShiftedByOnePixel) {
    const asset::Image whole = draw();
    for (const std::size_t shift : {std::size_t{4}, std::size_t{4} * kGateWidth}) {
        asset::Image shifted = whole;
        std::copy(whole.rgba.begin(), whole.rgba.end() - static_cast<std::ptrdiff_t>(shift),
                  shifted.rgba.begin() + static_cast<std::ptrdiff_t>(shift));
        EXPECT_FALSE(check(shifted));
    }
}

TEST_F(Gate, SeesAFlippedWinding) {
    EXPECT_FALSE(check(draw({}, {}, true)));
}

TEST_F(Gate, SeesWaterThatIsOnePercentLess) {
    EXPECT_FALSE(check(draw([](pot::Pot& pot) {
        for (float& liquidity : pot.liquidity)
            liquidity -= 0.01F;
    }))) << "the darkness of wet clay is part of the picture";
}

}  // namespace
}  // namespace onggi::golden

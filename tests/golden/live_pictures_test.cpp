// What a visitor sees where the processor is the device: the picture of the processor's backend, outlines
// smoothed, as the quality ladder asks for it on one core, against the one that was looked at.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "engine/render/quality.h"
#include "engine/render/renderer.h"
#include "engine/vk/offscreen.h"
#include "game/wheel/systems.h"
#include "game/wheel/workshop_scene.h"
#include "tests/golden/drawing_test.h"
#include "tests/golden/golden_scenes.h"
#include "tests/support/image_gate.h"

namespace onggi::golden {
namespace {

struct LiveScene {
    std::string name;
    std::string pot;  // one of the golden scenes
    double evening = 0.0;

    friend std::ostream& operator<<(std::ostream& out, const LiveScene& scene) { return out << scene.name; }
};

class LivePictures : public DrawingTest, public testing::WithParamInterface<LiveScene> {
  protected:
    // The third of three frames: in the first the room is made, in the others what has changed is laid over.
    [[nodiscard]] asset::Image draw(const GoldenScene& shown, double evening) const {
        auto opened = wheel::open_scene({}, shown.width, shown.height);
        EXPECT_EQ(opened.lack, "");
        opened.scene->transition(false);
        opened.scene->look_at(shown.view == wheel::StillView::kLookingIn ? wheel::View::kLookingIn
                                                                         : wheel::View::kThrowing);
        opened.scene->jump();
        wheel::Clay& clay = opened.scene->registry().get<wheel::Clay>(opened.scene->clay());
        clay.is_cut_open = clay.shows_load = shown.view == wheel::StillView::kCutaway;
        auto renderer = render::Renderer::create(
            *device_,
            render::quality_desc(render::QualityStep::kOneCore, vk::Offscreen::kFormat, shown.height));
        auto target = vk::Offscreen::create(
            *device_, {static_cast<std::uint32_t>(shown.width), static_cast<std::uint32_t>(shown.height)});
        for (int frame = 0; frame < 3; ++frame) {
            GoldenScene moved = shown;
            moved.tool_position_mm.y += 2.0 * (2 - frame);
            render::Scene scene = opened.scene->apply(moved.shown(), shown.width, shown.height);
            scene.levels = wheel::light_levels(evening);
            const auto drawn = (*renderer)->draw(scene, **target);
            EXPECT_TRUE(drawn && *drawn);
        }
        return {.width = shown.width, .height = shown.height, .rgba = (*target)->read_back().value()};
    }
};

TEST_P(LivePictures, EqualTheOnesThatWereLookedAt) {
    const GoldenScene shown = scene_named(GetParam().pot);
    ASSERT_FALSE(shown.name.empty());
    const support::RenderInfo info{.driver = device_->description().driver,
                                   .version = device_->description().driver_info,
                                   .driver_info = device_->description().driver_info,
                                   .state_hash = fmt::format("{:016x}", shown.hash())};
    EXPECT_TRUE(support::matches_golden(GetParam().name, draw(shown, GetParam().evening), info));
}

// A wet lump, hands at work, a bowl, a steep wall, a wall that is looked into, one that fell, one that is cut
// and shows its load, a glazed one, and evening.
INSTANTIATE_TEST_SUITE_P(OfThePot, LivePictures,
                         testing::Values(LiveScene{"live-centring", "centring"},
                                         LiveScene{"live-pulling", "pulling"}, LiveScene{"live-bowl", "wide"},
                                         LiveScene{"live-vase", "vase"}, LiveScene{"live-inside", "inside"},
                                         LiveScene{"live-failure", "failure"}, LiveScene{"live-load", "load"},
                                         LiveScene{"live-celadon", "celadon"},
                                         LiveScene{"live-evening", "stoneware-wet", 1.0}),
                         [](const auto& tested) { return test_name({.name = tested.param.name}); });

}  // namespace
}  // namespace onggi::golden

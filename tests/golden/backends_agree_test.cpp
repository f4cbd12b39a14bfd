// The CPU backend composes the picture from kept layers and rasterises the pot itself; the Vulkan backend
// draws everything on the device. The same pot must look the same in both.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <span>

#include "engine/asset/image.h"
#include "engine/render/quality.h"
#include "engine/render/renderer.h"
#include "engine/vk/offscreen.h"
#include "game/wheel/wheel_scene.h"
#include "tests/golden/alike.h"
#include "tests/golden/golden_scenes.h"
#include "tests/support/validated_device.h"

namespace onggi::golden {
namespace {

using render::Backend;

enum class Drawn { kClay, kLoad, kNoClay };

// A shader derives the width of the load's hatch lines for each 2x2 quad, the CPU for each pixel.
constexpr int kOnHatch = 2 * kOnTexels;

void expect_alike(const asset::Image& vulkan, const asset::Image& cpu, int most_levels,
                  Drawn drawn = Drawn::kClay) {
    ASSERT_EQ(vulkan.rgba.size(), cpu.rgba.size());
    // Layers are rounded to eight bits before they are mixed, and the mask's coordinates to half floats: one
    // level each. More is an edge that moved or a shadow that was cut off.
    const bool has_clay = drawn != Drawn::kNoClay;
    const int most = drawn == Drawn::kLoad ? kOnHatch : kOnTexels;
    const Apart found = apart(vulkan.rgba, cpu.rgba, most_levels);
    const auto width = static_cast<std::size_t>(vulkan.width);
    EXPECT_LE(found.beyond, has_clay ? most : 0)
        << found.worst << " levels at " << found.worst_at % width << ", " << found.worst_at / width;
    EXPECT_LE(apart(vulkan.rgba, cpu.rgba, kTexelsApart).beyond, has_clay ? kOnEdges : 0);
}

// The mean difference per channel.
constexpr double kMostInTheMean = 0.6;
constexpr int kOneInPixels = 150;  // may be farther apart than kTexelsApart
// Exceptions by name: grooves as fine as a pixel, which the CPU draws with fewer rings, also after a rib. In
// every scene one sample leaves the edges of the slip jagged that the CPU smooths.
constexpr int kOneInPixelsOfGrooves = 100;
int one_in_pixels(const GoldenScene& scene) {
    return scene.name == "rough-grooves" || scene.name == "rib" ? kOneInPixelsOfGrooves : kOneInPixels;
}

double mean_apart(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += std::abs(int{a[i]} - int{b[i]});
    return sum / static_cast<double>(a.size());
}

// The gleam of wet clay and the rims of the photographs are a few pixels wide.
constexpr double kMostOfStretching = 2.3;

// One of each kind is enough: solid, hollow, dented and off its centre, looked into, with hands, cut open,
// with its load, none, drawn on.
std::vector<GoldenScene> scenes_of_both_backends() {
    std::vector<GoldenScene> chosen;
    for (const GoldenScene& scene : golden_scenes()) {
        for (const char* name : {"stepped", "tool-pressing", "stoneware-wet", "celadon", "failure", "pulling",
                                 "cutaway", "load", "empty-wheel", "drawn-celadon"}) {
            if (scene.name == name) chosen.push_back(scene);
        }
    }
    return chosen;
}

class Backends : public support::ValidatedDevice, public testing::WithParamInterface<GoldenScene> {
  protected:
    [[nodiscard]] static Drawn drawn() {
        if (GetParam().name == "empty-wheel") return Drawn::kNoClay;
        return GetParam().name == "load" ? Drawn::kLoad : Drawn::kClay;
    }
    // Returns the last of several frames. The CPU backend renders the background for the first one, and later
    // shades it only where something has changed.
    asset::Image draw(wheel::WheelScene& wheel_scene, const GoldenScene& scene, Backend backend,
                      int frames = 1, const render::LightLevels& levels = {}) {
        return draw(wheel_scene, scene, strictly_alike(backend, scene.height), frames, levels);
    }
    // Sets the scene's camera at once.
    static void aim(wheel::WheelScene& wheel_scene, const GoldenScene& scene) {
        wheel_scene.look_at(scene.view == wheel::StillView::kLookingIn ? wheel::View::kLookingIn
                                                                       : wheel::View::kThrowing);
        wheel_scene.jump();
    }
    asset::Image draw(wheel::WheelScene& wheel_scene, const GoldenScene& scene,
                      const render::RendererDesc& desc, int frames, const render::LightLevels& levels) {
        const bool is_strict = desc.streaks_across == 1;
        const bool keeps_room = desc.backend == Backend::kCpu;
        auto renderer = render::Renderer::create(*device_, desc);
        auto target = vk::Offscreen::create(
            *device_, {static_cast<std::uint32_t>(scene.width), static_cast<std::uint32_t>(scene.height)});
        for (int frame = 0; frame < frames; ++frame) {
            // Draw something else first, so that leftovers would show.
            GoldenScene shown = scene;
            if (frame + 1 < frames) {
                for (float& radius : shown.pot.outer_mm)
                    radius += 5.0F;
            }
            wheel::Clay& clay = wheel_scene.registry().get<wheel::Clay>(wheel_scene.clay());
            clay.is_cut_open = clay.shows_load = scene.view == wheel::StillView::kCutaway;
            render::Scene lit = wheel_scene.apply(shown.shown(wheel_scene), scene.width, scene.height);
            if (is_strict) lit.props.clear();
            // By day first, so that the light changes.
            if (frame + 1 == frames) lit.levels = levels;
            const auto drawn = (*renderer)->draw(lit, **target);
            EXPECT_TRUE(drawn && *drawn);
            EXPECT_EQ((*renderer)->stats().still_life_drawn, !keeps_room || frame == 0);
        }
        return {.width = scene.width, .height = scene.height, .rgba = (*target)->read_back().value()};
    }
};

TEST_P(Backends, AgreeOnTheWorkshopWithinFourLevelsOfEightBits) {
    wheel::OpenedScene opened = wheel::open_scene({}, GetParam().width, GetParam().height);
    ASSERT_EQ(opened.lack, "");
    const asset::Image vulkan = draw(*opened.scene, GetParam(), Backend::kVulkan);
    // A level of a bright layer is two of the penumbra that is mixed from it and from a dark one.
    expect_alike(vulkan, draw(*opened.scene, GetParam(), Backend::kCpu), 4, drawn());
    // Where the shade hardly changes it is kept, at most one step of its mask off: two levels in the dark.
    expect_alike(vulkan, draw(*opened.scene, GetParam(), Backend::kCpu, 3), 6, drawn());
}

TEST_P(Backends, AgreeOnTheEveningWithinFourLevelsOfEightBits) {
    wheel::OpenedScene opened = wheel::open_scene({}, GetParam().width, GetParam().height);
    ASSERT_EQ(opened.lack, "");
    const render::LightLevels evening = wheel::light_levels(1.0);
    const asset::Image vulkan = draw(*opened.scene, GetParam(), Backend::kVulkan, 1, evening);
    for (const int frames : {1, 3})
        expect_alike(vulkan, draw(*opened.scene, GetParam(), Backend::kCpu, frames, evening), 4, drawn());
}

TEST_P(Backends, AgreeOnTheStillLifeWithinTwoLevelsOfEightBits) {
    wheel::WheelScene scene;
    const asset::Image vulkan = draw(scene, GetParam(), Backend::kVulkan);
    for (const int frames : {1, 3})
        expect_alike(vulkan, draw(scene, GetParam(), Backend::kCpu, frames), 2, drawn());
}

// The shipped settings: the kiosk's picture on one software core, with smoothed silhouettes, against that of
// the lowest full-size GPU step and against a still. They filter streaks and light hands differently; the
// mean difference must be small and large ones rare.
class BackendsAsTheyShip : public Backends {};
TEST_P(BackendsAsTheyShip, AgreeWithinSixTenthsOfALevelInTheMean) {
    wheel::OpenedScene opened = wheel::open_scene({}, GetParam().width, GetParam().height);
    ASSERT_EQ(opened.lack, "");
    aim(*opened.scene, GetParam());
    const auto as_shipped = [&](render::QualityStep step) {
        return render::quality_desc(step, vk::Offscreen::kFormat, GetParam().height);
    };
    const asset::Image live =
        draw(*opened.scene, GetParam(), as_shipped(render::QualityStep::kOneCore), 3, {});
    for (const render::QualityStep step :
         {render::QualityStep::kSlowGpu, render::QualityStep::kDiscreteGpu}) {
        const asset::Image shown = draw(*opened.scene, GetParam(), as_shipped(step), 1, {});
        const double mean = mean_apart(live.rgba, shown.rgba);
        const int beyond = apart(live.rgba, shown.rgba, kTexelsApart).beyond;
        EXPECT_LE(mean, kMostInTheMean) << render::quality_name(step);
        EXPECT_LE(beyond, GetParam().width * GetParam().height / one_in_pixels(GetParam()))
            << render::quality_name(step);
    }
}

// The lowest GPU steps render at three quarters and half of the size and scale up: softer, but at the same
// position.
TEST_P(Backends, AgreeWithSmallerPicturesThatAreStretchedInTheMean) {
    wheel::OpenedScene opened = wheel::open_scene({}, GetParam().width, GetParam().height);
    ASSERT_EQ(opened.lack, "");
    const auto as_shipped = [&](render::QualityStep step) {
        return draw(*opened.scene, GetParam(),
                    render::quality_desc(step, vk::Offscreen::kFormat, GetParam().height), 1, {});
    };
    const asset::Image whole = as_shipped(render::QualityStep::kDiscreteGpu);
    double least = 0.2;  // it is smaller
    for (const render::QualityStep step :
         {render::QualityStep::kSlowerGpu, render::QualityStep::kSlowestGpu}) {
        const double apart_by = mean_apart(whole.rgba, as_shipped(step).rgba);
        EXPECT_LE(apart_by, kMostOfStretching) << render::quality_name(step);
        EXPECT_GT(apart_by, least) << render::quality_name(step);
        least = apart_by;
    }
}

INSTANTIATE_TEST_SUITE_P(OfEveryScene, BackendsAsTheyShip, testing::ValuesIn(golden_scenes()),
                         [](const auto& tested) { return test_name(tested.param); });
INSTANTIATE_TEST_SUITE_P(OfThePot, Backends, testing::ValuesIn(scenes_of_both_backends()),
                         [](const auto& tested) { return test_name(tested.param); });

}  // namespace
}  // namespace onggi::golden

// The processor's backend puts the picture together from layers that it keeps and draws the pot itself, the
// Vulkan backend has the device draw everything: the same pot must look the same in both.
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

// How wide a line of the load's hatch is a shader finds out from two pixels by two, the processor at each.
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

// Of a channel.
constexpr double kMostInTheMean = 0.6;
constexpr int kOneInPixels = 150;  // may be farther apart than kTexelsApart
// Named: grooves as fine as a pixel, which the processor draws by fewer rings, and what a rib leaves of them.
constexpr int kOneInPixelsOfGrooves = 110;
int one_in_pixels(const GoldenScene& scene) {
    return scene.name == "rough-grooves" || scene.name == "rib" ? kOneInPixelsOfGrooves : kOneInPixels;
}

double mean_apart(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += std::abs(int{a[i]} - int{b[i]});
    return sum / static_cast<double>(a.size());
}

constexpr double kMostOfStretching = 2.0;

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
    // The last of some frames. The processor has the still life drawn for the first of them, and shades it
    // for those after it only where something has changed.
    asset::Image draw(wheel::WheelScene& wheel_scene, const GoldenScene& scene, Backend backend,
                      int frames = 1, const render::LightLevels& levels = {}) {
        return draw(wheel_scene, scene, strictly_alike(backend, scene.height), frames, levels);
    }
    // From where the scene is seen, at once.
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
            // Something else first, so that what is left of it would show.
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
    // Where the shade hardly changes it stays as it is, a step of its mask off at most: two levels in the
    // dark.
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

// What ships: the picture of the kiosk on one software core, outlines smoothed, beside that of the lowest GPU
// that draws in full size and beside a still. Each reads streaks and lights hands in its own way; what they
// may differ by is little in the mean and seldom much.
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

// The lowest steps of a GPU draw three quarters and half of the pixels each way and stretch them: softer, and
// in its place.
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

// The live picture is put together from cached layers, the still one is drawn whole: the same pot must look
// the same in both.
#include <gtest/gtest.h>

#include "engine/asset/image.h"
#include "engine/render/renderer.h"
#include "engine/vk/offscreen.h"
#include "game/wheel/systems.h"
#include "game/wheel/workshop_scene.h"
#include "tests/golden/drawing_test.h"
#include "tests/golden/golden_scenes.h"

namespace onggi::golden {
namespace {

enum class Drawn { kClay, kLoad, kNoClay };

// How wide a line of the load's hatch is a shader finds out from two pixels by two, the processor at each.
constexpr int kOnHatch = 2 * kOnTexels;

void expect_alike(const asset::Image& direct, const asset::Image& cached, int most_levels,
                  Drawn drawn = Drawn::kClay) {
    ASSERT_EQ(direct.rgba.size(), cached.rgba.size());
    // Layers are rounded to eight bits before they are mixed, and the mask's coordinates to half floats: one
    // level each. More is an edge that moved or a shadow that was cut off.
    const bool has_clay = drawn != Drawn::kNoClay;
    const int most = drawn == Drawn::kLoad ? kOnHatch : kOnTexels;
    const Apart found = apart(direct.rgba, cached.rgba, most_levels);
    const auto width = static_cast<std::size_t>(direct.width);
    EXPECT_LE(found.beyond, has_clay ? most : 0)
        << found.worst << " levels at " << found.worst_at % width << ", " << found.worst_at / width;
    EXPECT_LE(apart(direct.rgba, cached.rgba, kTexelsApart).beyond, has_clay ? kOnEdges : 0);
}

// One of each kind is enough: solid, hollow, dented and off its centre, looked into, with hands, cut open,
// with its load, none.
std::vector<GoldenScene> scenes_of_both_paths() {
    std::vector<GoldenScene> chosen;
    for (const GoldenScene& scene : golden_scenes()) {
        for (const char* name : {"stepped", "tool-pressing", "stoneware-wet", "celadon", "failure", "pulling",
                                 "cutaway", "load", "empty-wheel"}) {
            if (scene.name == name) chosen.push_back(scene);
        }
    }
    return chosen;
}

class RenderPaths : public DrawingTest, public testing::WithParamInterface<GoldenScene> {
  protected:
    [[nodiscard]] static Drawn drawn() {
        if (GetParam().name == "empty-wheel") return Drawn::kNoClay;
        return GetParam().name == "load" ? Drawn::kLoad : Drawn::kClay;
    }
    // The last of some frames. With the cache the still life is drawn for the first of them, and shaded for
    // those after it only where something has changed.
    asset::Image draw(wheel::WheelScene& wheel_scene, const GoldenScene& scene, bool cached, int frames = 1,
                      const render::LightLevels& levels = {}) {
        render::RendererDesc desc = render::live_desc(vk::Offscreen::kFormat, true, scene.height);
        desc.cached = cached;
        desc.smooths_outlines = false;  // only the cached picture is smoothed
        auto renderer = render::Renderer::create(*device_, desc);
        auto target = vk::Offscreen::create(
            *device_, {static_cast<std::uint32_t>(scene.width), static_cast<std::uint32_t>(scene.height)});
        for (int frame = 0; frame < frames; ++frame) {
            // Something else first, so that what is left of it would show.
            GoldenScene shown = scene;
            if (frame + 1 < frames) {
                std::fill(shown.radii_mm.begin(), shown.radii_mm.end(), 60.0F);
                for (float& radius : shown.studio.outer_mm)
                    radius += 5.0F;
            }
            wheel::Clay& clay = wheel_scene.registry().get<wheel::Clay>(wheel_scene.clay());
            clay.is_cut_open = clay.shows_load = scene.view == wheel::StillView::kCutaway;
            render::Scene lit = wheel_scene.apply(shown.pot(), scene.width, scene.height);
            // By day first, so that the light changes.
            if (frame + 1 == frames) lit.levels = levels;
            const auto drawn = (*renderer)->draw(lit, **target);
            EXPECT_TRUE(drawn && *drawn);
            EXPECT_EQ((*renderer)->stats().still_life_drawn, !cached || frame == 0);
        }
        return {.width = scene.width, .height = scene.height, .rgba = (*target)->read_back().value()};
    }
};

TEST_P(RenderPaths, AgreeOnTheWorkshopWithinFourLevelsOfEightBits) {
    wheel::OpenedScene opened = wheel::open_scene({}, GetParam().width, GetParam().height);
    ASSERT_EQ(opened.lack, "");
    const asset::Image direct = draw(*opened.scene, GetParam(), false);
    // A level of a bright layer is two of the penumbra that is mixed from it and from a dark one.
    expect_alike(direct, draw(*opened.scene, GetParam(), true), 4, drawn());
    // Where the shade hardly changes it stays as it is, a step of its mask off at most: two levels in the
    // dark.
    expect_alike(direct, draw(*opened.scene, GetParam(), true, 3), 6, drawn());
}

TEST_P(RenderPaths, AgreeOnTheEveningWithinFourLevelsOfEightBits) {
    wheel::OpenedScene opened = wheel::open_scene({}, GetParam().width, GetParam().height);
    ASSERT_EQ(opened.lack, "");
    const render::LightLevels evening = wheel::light_levels(1.0);
    const asset::Image direct = draw(*opened.scene, GetParam(), false, 1, evening);
    for (const int frames : {1, 3})
        expect_alike(direct, draw(*opened.scene, GetParam(), true, frames, evening), 4, drawn());
}

TEST_P(RenderPaths, AgreeOnTheStillLifeWithinTwoLevelsOfEightBits) {
    wheel::WheelScene scene;
    const asset::Image direct = draw(scene, GetParam(), false);
    for (const int frames : {1, 3})
        expect_alike(direct, draw(scene, GetParam(), true, frames), 2, drawn());
}

INSTANTIATE_TEST_SUITE_P(OfThePot, RenderPaths, testing::ValuesIn(scenes_of_both_paths()),
                         [](const auto& tested) { return test_name(tested.param); });

}  // namespace
}  // namespace onggi::golden

// After a change of the window's aspect the backgrounds of that aspect are loaded beside the frames.
#include "game/wheel/workshop_files.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "game/wheel/wheel_scene.h"
#include "tests/support/comes_true.h"
#include "tests/unit/wheel/our_workshop.h"

namespace onggi::wheel {
namespace {

// Waits for a result; empty after a timeout.
std::optional<BackgroundLoader::Loaded> waited_for(BackgroundLoader& loader) {
    std::optional<BackgroundLoader::Loaded> loaded;
    test::comes_true([&] { return (loaded = loader.take()).has_value(); });
    return loaded;
}

std::vector<BackgroundCamera> copies(const std::vector<const BackgroundCamera*>& cameras) {
    std::vector<BackgroundCamera> copied;
    for (const BackgroundCamera* camera : cameras)
        copied.push_back(*camera);
    return copied;
}

TEST(BackgroundLoader, LoadsPortraitBackgroundsForASceneOpenedInLandscape) {
    OpenedScene opened = open_scene({}, 1280, 720);
    ASSERT_EQ(opened.lack, "");
    WheelScene& scene = *opened.scene;
    ASSERT_TRUE(scene.missing_backgrounds(1280, 720).empty());
    const auto missing = copies(scene.missing_backgrounds(720, 1280));
    ASSERT_EQ(missing.size(), 2U);
    EXPECT_EQ(missing[0].name, "throw_9x16");
    EXPECT_EQ(missing[1].name, "look_in_9x16");
    const pot::Pot pot{.outer_mm = std::vector<float>(100, 50.0F), .height_mm = 200.0};
    const auto shown = [&](int width, int height) {
        return scene.apply({.pot = &pot}, width, height).background;
    };
    const auto landscape = shown(1280, 720);
    EXPECT_EQ(shown(720, 1280), landscape) << "until then its middle is shown";

    BackgroundLoader loader;
    EXPECT_FALSE(loader.busy());
    EXPECT_FALSE(loader.take());
    ASSERT_TRUE(loader.load(scene.workshop(), missing));
    EXPECT_TRUE(loader.busy());
    auto loaded = waited_for(loader);
    ASSERT_TRUE(loaded);
    EXPECT_FALSE(loader.busy());
    EXPECT_TRUE(loaded->lacks.empty());
    for (auto& [camera, background] : loaded->backgrounds)
        scene.add_background(camera, std::move(background));
    scene.drop_backgrounds_of_other_shapes(720, 1280);
    const auto portrait = shown(720, 1280);
    ASSERT_NE(portrait, nullptr);
    EXPECT_NE(portrait, landscape);
    EXPECT_GT(portrait->height_px, portrait->width_px);
    EXPECT_EQ(scene.missing_backgrounds(1280, 720).size(), 2U) << "the landscape's are forgotten";
    EXPECT_TRUE(scene.missing_backgrounds(720, 1280).empty());
}

TEST(BackgroundLoader, ReportsUnreadableBackgroundsAndLoadsTheOthers) {
    auto workshop = load_workshop(kOurs);
    ASSERT_TRUE(workshop) << workshop.error().message;
    const auto shared = std::make_shared<const Workshop>(std::move(*workshop));
    BackgroundCamera gone = *shared->camera_for(View::kThrowing, 4, 3);
    gone.name = "throw_gone";
    BackgroundLoader loader;
    ASSERT_TRUE(loader.load(shared, {gone, *shared->camera_for(View::kThrowing, 4, 3)}));
    const auto loaded = waited_for(loader);
    ASSERT_TRUE(loaded);
    ASSERT_EQ(loaded->backgrounds.size(), 1U);
    EXPECT_EQ(loaded->backgrounds[0].first, "throw_4x3");
    ASSERT_EQ(loaded->lacks.size(), 1U);
    EXPECT_NE(loaded->lacks[0].find("throw_gone_key.jpg"), std::string::npos) << loaded->lacks[0];
}

TEST(BackgroundLoader, CanBeDestroyedWhileItLoads) {
    auto workshop = load_workshop(kOurs);
    ASSERT_TRUE(workshop);
    const auto shared = std::make_shared<const Workshop>(std::move(*workshop));
    BackgroundLoader loader;
    ASSERT_TRUE(loader.load(shared, shared->cameras));
}

}  // namespace
}  // namespace onggi::wheel

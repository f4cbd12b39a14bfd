// Two independent drivers draw the same stills: lavapipe's stored ones, and those of the driver under test,
// SwiftShader's or a GPU's.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/asset/image.h"
#include "engine/files/read_file.h"
#include "game/wheel/still.h"
#include "tests/golden/golden_scenes.h"
#include "tests/support/image_compare.h"
#include "tests/support/places.h"

namespace onggi::golden {
namespace {

constexpr int kMostLevels = 5;  // of 255, in any channel, counts as alike
// Of the pixels; grooves as fine as a pixel are aliased differently.
double most_apart(const GoldenScene& scene) {
    return scene.name == "rough-grooves" ? 0.004 : 0.003;
}
// Of 255. The most is seen where the photographed room fills the picture, because its filtering rounds
// differently.
constexpr double kMostInTheMean = 0.5;

class Stills : public testing::TestWithParam<GoldenScene> {};

TEST_P(Stills, AreThoseOfTheOtherDriver) {
    const GoldenScene& scene = GetParam();
    const auto file = test::in_checkout("tests/golden/images/lavapipe-22.3/" + scene.name + ".png");
    constexpr std::size_t kMostBytes = 4'000'000;
    const auto png = files::read_file(file, kMostBytes);
    ASSERT_TRUE(png) << png.error().message;
    const auto expected = asset::decode_png(std::as_bytes(std::span(*png)), scene.name);
    ASSERT_TRUE(expected) << expected.error().message;
    // Any message of the validation layer is an error.
    const auto drawn = scene.drawn_alone(scene.width, scene.height, {.validation = true});
    ASSERT_TRUE(drawn) << drawn.error().message;
    const support::ImageDifference found = support::compare_images(*expected, *drawn, kMostLevels);
    fmt::print("{}: {:.4f} % of pixels differ by more than {}/255, mean {:.4f}\n", scene.name,
               100.0 * found.bad_fraction, kMostLevels, found.mean_delta);
    EXPECT_LE(found.bad_fraction, most_apart(scene));
    EXPECT_LE(found.mean_delta, kMostInTheMean);
}

INSTANTIATE_TEST_SUITE_P(OfThePot, Stills, testing::ValuesIn(golden_scenes()),
                         [](const auto& tested) { return test_name(tested.param); });

}  // namespace
}  // namespace onggi::golden

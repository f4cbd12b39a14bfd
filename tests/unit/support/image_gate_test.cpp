// The gate must reject each kind of wrong picture.
#include "tests/support/image_gate.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "tests/support/image_compare.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/support/synthetic_pot.h"

namespace onggi::support {
namespace {

using asset::Image;
using std::filesystem::path;

const RenderInfo kLavapipe{"llvmpipe", "Mesa 22.3.6", "Mesa 22.3.6 (LLVM 15.0.6)", "0123456789abcdef"};

class ImageGate : public testing::Test {
  protected:
    ImageGate() {
        options_.golden_folder = folder_ / "lavapipe-22.3";
        options_.output_folder = folder_ / "out";
        options_.dirty_paths = [] { return Result<std::string>(std::string()); };
    }

    void bless(const Image& image, const RenderInfo& info = kLavapipe) {
        GateOptions options = options_;
        options.bless = {"vase"};
        ASSERT_TRUE(matches_golden("vase", image, info, options));
    }
    [[nodiscard]] testing::AssertionResult check(const Image& image,
                                                 const RenderInfo& info = kLavapipe) const {
        return matches_golden("vase", image, info, options_);
    }
    [[nodiscard]] bool was_saved(const std::string& what) const {
        return std::filesystem::exists(options_.output_folder / ("vase." + what + ".png"));
    }
    void write(const path& file, std::string_view text) const {
        std::ofstream(file, std::ios::binary) << text;
    }
    [[nodiscard]] std::string read(const path& file) const {
        std::ostringstream text;
        text << std::ifstream(file, std::ios::binary).rdbuf();
        return text.str();
    }

    test::TemporaryFolder folder_;
    GateOptions options_;
};

// Drawn once for all: three fifths of a second in a debug build.
const Image& pot() {
    static const Image image = draw_pot({});
    return image;
}

TEST_F(ImageGate, PassesTheSamePicture) {
    bless(pot());
    EXPECT_TRUE(check(pot()));
    EXPECT_FALSE(was_saved("actual"));
}

TEST_F(ImageGate, PassesTheNoiseOfOneDriver) {
    bless(pot());
    Image noisy = pot();
    // The worst that other processor features were seen to change: 11 pixels by one step.
    for (std::size_t i = 0; i < 11; ++i)
        noisy.rgba[40000 + 4 * 7919 * i] ^= 1;
    EXPECT_TRUE(check(noisy));
}

TEST_F(ImageGate, FailsAPotShiftedByOnePixel) {
    bless(pot());
    EXPECT_FALSE(check(draw_pot({.shift_px = 1.0})));
}

TEST_F(ImageGate, FailsAPotWiderByATwentiethOfAMillimetre) {
    bless(pot());
    const Image wider = draw_pot({.wider_mm = 0.05});
    EXPECT_FALSE(check(wider));
    const ImageDifference difference = compare_images(pot(), wider, kSameDriver.delta_limit);
    EXPECT_GT(difference.bad_fraction, kSameDriver.bad_fraction);
    EXPECT_GT(difference.mean_delta, kSameDriver.mean_delta);
}

TEST_F(ImageGate, FailsLightThatIsOnePercentWeakerThoughNoPixelDiffersVisibly) {
    bless(pot());
    const Image darker = draw_pot({.light = 0.99});
    EXPECT_FALSE(check(darker));
    const ImageDifference difference = compare_images(pot(), darker, kSameDriver.delta_limit);
    EXPECT_EQ(difference.bad_fraction, 0.0) << "the mean alone must have caught it";
}

TEST_F(ImageGate, FailsAFewWrongPixelsThoughTheMeanIsFine) {
    bless(pot());
    Image spotted = pot();
    const std::size_t pixels = spotted.rgba.size() / 4;
    for (std::size_t i = 0; i < pixels / 1000; ++i)
        spotted.rgba[4 * 997 * i] ^= 4;
    EXPECT_FALSE(check(spotted));
    EXPECT_LT(compare_images(pot(), spotted, 2).mean_delta, kSameDriver.mean_delta);
}

TEST_F(ImageGate, FailsAnEmptyPicture) {
    bless(pot());
    Image black{pot().width, pot().height, std::vector<std::uint8_t>(pot().rgba.size(), 0)};
    EXPECT_FALSE(check(black));
    EXPECT_FALSE(check({}));
}

TEST_F(ImageGate, FailsWithoutAGoldenAndStoresNone) {
    EXPECT_FALSE(check(pot()));
    EXPECT_FALSE(std::filesystem::exists(options_.golden_folder / "vase.png"));
    EXPECT_TRUE(was_saved("actual"));
}

TEST_F(ImageGate, FailsAnotherSize) {
    bless(pot());
    const testing::AssertionResult result = check(draw_pot({.width = 641}));
    EXPECT_FALSE(result);
    EXPECT_NE(std::string(result.message()).find("expected 640 x 480 pixels, found 641 x 480"),
              std::string::npos);
}

TEST_F(ImageGate, FailsAGoldenThatIsNoPng) {
    bless(pot());
    write(options_.golden_folder / "vase.png", "not a picture");
    EXPECT_FALSE(check(pot()));
    const std::string whole = read(options_.golden_folder / "vase.png");
    write(options_.golden_folder / "vase.png", whole.substr(0, whole.size() / 2));
    EXPECT_FALSE(check(pot()));
}

TEST_F(ImageGate, FailsWithoutASidecarOrWithADamagedOne) {
    bless(pot());
    const path sidecar = options_.golden_folder / "vase.json";
    const std::string good = read(sidecar);
    for (const std::string& bad : {std::string(), std::string("{}"), std::string("[1"), good.substr(1),
                                   std::string(R"({"driver": 1})")}) {
        write(sidecar, bad);
        EXPECT_FALSE(check(pot())) << bad;
    }
    std::filesystem::remove(sidecar);
    EXPECT_FALSE(check(pot()));
}

TEST_F(ImageGate, FailsASidecarThatAllowsMoreThanTheHouse) {
    bless(pot());
    const path sidecar = options_.golden_folder / "vase.json";
    std::string text = read(sidecar);
    const std::string limit = "\"mean_delta\": 0.02";
    ASSERT_NE(text.find(limit), std::string::npos) << text;
    write(sidecar, text.replace(text.find(limit), limit.size(), "\"mean_delta\": 0.2"));
    EXPECT_FALSE(check(pot()));
}

TEST_F(ImageGate, ShowsTheDifferences) {
    bless(pot());
    Image wrong = pot();
    const std::size_t at = (100 * 640 + 320) * 4;
    for (std::size_t i = 0; i < 400; ++i)
        wrong.rgba[at + 4 * i] = 0;
    RenderInfo info = kLavapipe;
    info.state_hash = "feedfacefeedface";
    const testing::AssertionResult result = check(wrong, info);
    ASSERT_FALSE(result);
    const std::string story = result.message();
    EXPECT_NE(story.find("pixel 320,100: off by"), std::string::npos) << story;
    EXPECT_NE(story.find("feedfacefeedface"), std::string::npos)
        << "the state's hash tells clay from renderer";
    EXPECT_NE(story.find("................................"), std::string::npos) << "the map";
    for (const char* what : {"actual", "expected", "diff"})
        EXPECT_TRUE(was_saved(what)) << what;
}

TEST_F(ImageGate, OnAnotherDriverReportsAndFailsOnlyIfStrict) {
    bless(pot());
    RenderInfo other = kLavapipe;
    other.version = "Mesa 25.0.1";
    const Image shifted = draw_pot({.shift_px = 1.0});
    EXPECT_TRUE(check(shifted, other));
    EXPECT_TRUE(was_saved("diff"));
    options_.strict = true;
    EXPECT_FALSE(check(shifted, other));
    EXPECT_TRUE(check(draw_pot({.light = 0.99}), other)) << "within 5/255";
}

TEST_F(ImageGate, HoldsAnotherReleaseToItsOwnPictureWhereThereIsOne) {
    bless(pot());
    const RenderInfo later{"llvmpipe", "Mesa 25.0.7-2 (LLVM 19.1.7)", "Mesa 25.0.7-2 (LLVM 19.1.7)",
                           kLavapipe.state_hash};
    const Image shifted = draw_pot({.shift_px = 1.0});
    bless(shifted, later);
    EXPECT_TRUE(std::filesystem::exists(folder_ / "lavapipe-25.0/vase.png"));
    EXPECT_TRUE(check(pot())) << "the first release has its own";
    EXPECT_TRUE(check(shifted, later));
    EXPECT_FALSE(check(pot(), later)) << "by the limits of one driver";
}

TEST_F(ImageGate, StoresOnlyTheNamedScenes) {
    options_.bless = {"neck"};
    EXPECT_FALSE(check(pot()));
    EXPECT_FALSE(std::filesystem::exists(options_.golden_folder / "vase.png"));
}

TEST_F(ImageGate, StoresTheDriverTheStateAndTheTolerances) {
    bless(pot());
    const std::string text = read(options_.golden_folder / "vase.json");
    for (const std::string& word : {kLavapipe.driver, kLavapipe.version, kLavapipe.driver_info,
                                    kLavapipe.state_hash, std::string("\"bad_share\": 0.0005")}) {
        EXPECT_NE(text.find(word), std::string::npos) << word << " in " << text;
    }
}

TEST_F(ImageGate, StoresNoPictureInCi) {
    options_.bless = {"vase"};
    options_.in_ci = true;
    EXPECT_FALSE(check(pot()));
    EXPECT_FALSE(std::filesystem::exists(options_.golden_folder));
}

TEST_F(ImageGate, StoresNoPictureFromADirtyTree) {
    options_.bless = {"vase"};
    options_.dirty_paths = [] { return Result<std::string>(std::string(" M game/clay/paper_clay.cpp\n")); };
    EXPECT_FALSE(check(pot()));
    options_.dirty_paths = [] { return Result<std::string>(failed("no git")); };
    EXPECT_FALSE(check(pot()));
    EXPECT_FALSE(std::filesystem::exists(options_.golden_folder));
}

TEST_F(ImageGate, RejectsNamesThatLeaveTheFolder) {
    for (const char* name : {"", "../vase", "a/b", "Vase", "vase.png"}) {
        EXPECT_FALSE(matches_golden(name, pot(), kLavapipe, options_)) << name;
    }
}

TEST_F(ImageGate, FindsUncommittedFilesOutsideTheGoldens) {
    const path repository = folder_ / "repository";
    std::filesystem::create_directories(repository / "tests/golden");
    EXPECT_FALSE(dirty_paths_outside_goldens(folder_ / "nowhere"));
    const std::string git = "git -C '" + repository.string() + "' ";
    ASSERT_EQ(std::system((git + "init --quiet").c_str()), 0);
    write(repository / "tests/golden/vase.png", "new");
    Result<std::string> dirty = dirty_paths_outside_goldens(repository);
    ASSERT_TRUE(dirty) << dirty.error().message;
    EXPECT_EQ(*dirty, "");
    write(repository / "clay.cpp", "new");
    dirty = dirty_paths_outside_goldens(repository);
    ASSERT_TRUE(dirty);
    EXPECT_EQ(*dirty, "?? clay.cpp\n");
}

TEST(CompareImages, CountsTheMostDifferingChannelAlphaIncluded) {
    const Image expected{2, 1, {10, 20, 30, 255, 0, 0, 0, 255}};
    const Image actual{2, 1, {12, 20, 27, 255, 0, 0, 0, 249}};
    const ImageDifference difference = compare_images(expected, actual, 3);
    EXPECT_DOUBLE_EQ(difference.mean_delta, 4.5);
    EXPECT_DOUBLE_EQ(difference.bad_fraction, 0.5);
    ASSERT_EQ(difference.worst.size(), 2U);
    EXPECT_EQ(difference.worst[0].x, 1);
    EXPECT_EQ(difference.worst[0].delta, 6);
    EXPECT_EQ(difference_map(expected, actual), "=+\n");
    EXPECT_EQ(difference_image(expected, actual).rgba,
              (std::vector<std::uint8_t>{32, 0, 48, 255, 0, 0, 0, 255}));
}

}  // namespace
}  // namespace onggi::support

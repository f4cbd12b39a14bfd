#include "game/wheel/workshop_files.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "game/wheel/wheel_scene.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/wheel/our_workshop.h"

namespace onggi::wheel {
namespace {

namespace fs = std::filesystem;

// A copy of the workshop's JSON files in which one thing can be spoiled.
class WorkshopFiles : public testing::Test {
  protected:
    void SetUp() override { restore(); }
    // Both files as they were.
    void restore() {
        for (const char* file : {"cameras.json", "light.json"})
            fs::copy_file(kOurs / file, folder_ / file, fs::copy_options::overwrite_existing);
    }

    // At first only the existence of a camera's photographs is checked.
    void put_photograph(const std::string& camera) {
        fs::create_directories(folder_ / "plates");
        std::ofstream(folder_ / "plates" / (camera + "_key.jpg")) << "a photograph";
    }
    void put(const char* file, const std::string& text) {
        std::ofstream(folder_ / file, std::ios::binary) << text;
    }
    // The first `before` of the file becomes `after`.
    void spoil(const char* file, const std::string& before, const std::string& after) {
        std::string text = test::content_of(folder_ / file);
        const std::size_t at = text.find(before);
        ASSERT_NE(at, std::string::npos) << before;
        put(file, text.replace(at, before.size(), after));
    }
    void expect_refused(const std::string& words) {
        const auto workshop = load_workshop(folder_.path());
        ASSERT_FALSE(workshop) << words;
        EXPECT_EQ(workshop.error().kind, ErrorKind::kBadInput);
        EXPECT_NE(workshop.error().message.find(words), std::string::npos) << workshop.error().message;
        EXPECT_EQ(workshop.error().message.find('\n'), std::string::npos);
    }

    const test::TemporaryFolder folder_;
};

TEST_F(WorkshopFiles, DescribeTheCamerasAndTheLight) {
    const auto workshop = load_workshop(kOurs);
    ASSERT_TRUE(workshop) << workshop.error().message;
    const BackgroundCamera* camera = workshop->camera_for(View::kThrowing, 1280, 720);
    ASSERT_NE(camera, nullptr);
    EXPECT_EQ(camera->name, "throw_16x9");
    EXPECT_EQ(camera->camera.eye_mm, vec3(0.0F, 285.0F, 805.0F));
    EXPECT_NEAR(glm::length(workshop->key.towards_light), 1.0F, 1e-6F);
    EXPECT_GT(workshop->irradiance[0].x, 0.0F);
}

TEST_F(WorkshopFiles, ChooseTheCameraWhoseShapeIsNearest) {
    const auto workshop = load_workshop(folder_.path());
    ASSERT_TRUE(workshop);
    const auto name = [&](int width, int height) {
        return workshop->camera_for(View::kThrowing, width, height)->name;
    };
    EXPECT_EQ(name(3840, 2160), "throw_16x9");
    EXPECT_EQ(name(2560, 1080), "throw_16x9");
    EXPECT_EQ(name(1024, 768), "throw_4x3");
    EXPECT_EQ(name(1280, 1024), "throw_4x3");
    EXPECT_EQ(name(1080, 1920), "throw_9x16");
    EXPECT_EQ(workshop->camera_for(View::kLookingIn, 1080, 1920)->name, "look_in_9x16");
}

TEST_F(WorkshopFiles, ChooseTheLargerPhotographsForALargePictureWhereTheRoomHasSome) {
    put_photograph("throw_16x9_x3");
    const auto workshop = load_workshop(folder_.path());
    ASSERT_TRUE(workshop) << workshop.error().message;
    const auto camera = [&](int width, int height) {
        return *workshop->camera_for(View::kThrowing, width, height);
    };
    EXPECT_EQ(camera(1280, 720).name, "throw_16x9");
    EXPECT_EQ(camera(1920, 1080).name, "throw_16x9");
    EXPECT_EQ(camera(2560, 1440).name, "throw_16x9_x3");
    EXPECT_EQ(camera(3840, 2160).name, "throw_16x9_x3");
    EXPECT_EQ(camera(2160, 3840).name, "throw_9x16") << "of which there are none";
    EXPECT_EQ(camera(3840, 2160).camera, camera(1280, 720).camera);
    EXPECT_EQ(camera(3840, 2160).height_px, 2160);
    EXPECT_EQ(workshop->cameras.size(), 6U);
}

TEST_F(WorkshopFiles, RejectsALargerVariantOfAMissingCamera) {
    put_photograph("throw_16x9_x2");
    spoil("cameras.json", "\"larger_than\": \"throw_16x9\"", "\"larger_than\": \"throw_1x1\"");
    expect_refused(
        "cameras.throw_16x9_x2.larger_than: expected the name of a camera that is not larger than "
        "another, found "
        "'throw_1x1'");
    spoil("cameras.json", "\"larger_than\": \"throw_1x1\"", "\"larger_than\": \"throw_16x9_x2\"");
    expect_refused("cameras.throw_16x9_x2.larger_than: expected the name");
    spoil("cameras.json", "\"larger_than\": \"throw_16x9_x2\"", "\"larger_than\": 3");
    expect_refused(
        "cameras.throw_16x9_x2.larger_than: expected the name of a camera that is not larger than "
        "another, found no name");
}

TEST_F(WorkshopFiles, BringBothBackgroundsOfACamera) {
    const auto workshop = load_workshop(kOurs);
    ASSERT_TRUE(workshop);
    const auto background = load_background(*workshop, *workshop->camera_for(View::kThrowing, 1024, 768));
    ASSERT_TRUE(background) << background.error().message;
    const auto brightness = [](const asset::Image& image) {
        double sum = 0.0;
        for (const std::uint8_t value : image.rgba)
            sum += value;
        return sum / static_cast<double>(image.rgba.size());
    };
    render::Photographs& photographs = *(*background)->photographs;
    const auto pair = photographs.pair();
    ASSERT_TRUE(pair);
    EXPECT_GT(brightness((*pair)->key), brightness((*pair)->ambient) + 10.0);

    const render::PhotographPair first = **pair;
    photographs.let_go();
    EXPECT_FALSE(photographs.are_here()) << "once on the device they only cost memory";
    const auto again = photographs.pair();
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ((*again)->key, first.key);
    EXPECT_EQ((*again)->ambient, first.ambient);
}

TEST_F(WorkshopFiles, RejectsAMissingFile) {
    fs::remove(folder_ / "light.json");
    expect_refused("light.json: no such file");
    fs::remove(folder_ / "cameras.json");
    expect_refused("cameras.json: no such file");
}

TEST_F(WorkshopFiles, RejectsInvalidJson) {
    for (const char* text : {"", "{", "[1, 2]", "\xFF\xFE", "{\"cameras\": 1} more"}) {
        put("cameras.json", text);
        expect_refused("cameras.json: ");
    }
    put("cameras.json", std::string(200000, '['));
    expect_refused("expected a JSON object, found no JSON");
}

TEST_F(WorkshopFiles, RejectsAMissingOrWrongFieldByItsName) {
    spoil("cameras.json", "\"vertical_fov_rad\": 0.471, \"size\": [1280", "\"fov\": 0.471, \"size\": [1280");
    expect_refused("cameras.throw_16x9.vertical_fov_rad: expected a number from 0.02 to 2.6, found nothing");
    spoil("cameras.json", "\"fov\": 0.471", "\"vertical_fov_rad\": \"wide\"");
    expect_refused("cameras.throw_16x9.vertical_fov_rad: expected a number from 0.02 to 2.6, found a text");
    spoil("cameras.json", "\"wide\"", "1e400");
    expect_refused("cameras.json: ");
}

TEST_F(WorkshopFiles, RejectsSizesThatNoBackgroundHas) {
    for (const char* size : {"[1280]", "[0, 720]", "[1e9, 720]", "[1280.5, 720]", "\"big\""}) {
        restore();
        spoil("cameras.json", "[1280, 720]", size);
        expect_refused("cameras.throw_16x9.size: expected");
    }
    restore();
}

TEST_F(WorkshopFiles, RejectsACameraThatLooksStraightUpOrDown) {
    spoil("cameras.json", "[0, 285, 805]", "[0, 285, 0]");
    expect_refused("cameras.throw_16x9: expected a camera that does not look straight up or down");
}

TEST_F(WorkshopFiles, RejectsANameThatLeadsOutOfTheFolder) {
    spoil("cameras.json", "\"throw_16x9\": {", "\"throw/../../x\": {");
    expect_refused("cameras: expected names of at most 64 letters");
}

TEST_F(WorkshopFiles, RejectsARoomWithoutAThrowingCamera) {
    put("cameras.json", "{\"cameras\": {}}");
    expect_refused("cameras: expected one whose name begins with throw, found none");
}

TEST_F(WorkshopFiles, RejectsInvalidLight) {
    spoil("light.json", "-0.71145", "-7.1145");
    expect_refused("light.json: key.towards_light: expected a number from -1 to 1, found -7.1145");
    spoil("light.json", "-7.1145", "-0.1");
    expect_refused("light.json: key.towards_light: expected a direction of length 1, found length 0.710");
    spoil("light.json", "-0.1", "-0.71145");
    spoil("light.json", "0.54065", "-0.54065");
    expect_refused("key.towards_light: expected a light from above");
    spoil("light.json", "-0.54065", "0.54065");
    spoil("light.json", "\"coefficients\": [", "\"coefficients\": [[0, 0, 0],");
    expect_refused("irradiance_over_pi.coefficients: expected an array of 9, found an array of 10");
}

TEST_F(WorkshopFiles, RejectsBackgroundsThatAreMissingDamagedOrOfAnotherSize) {
    const auto workshop = load_workshop(folder_.path());
    ASSERT_TRUE(workshop);
    const BackgroundCamera& camera = *workshop->camera_for(View::kThrowing, 1280, 720);
    const auto refusal = [&] {
        const auto background = load_background(*workshop, camera);
        return background ? std::string("none") : background.error().message;
    };
    EXPECT_NE(refusal().find("throw_16x9_key.jpg: no such file"), std::string::npos);
    fs::create_directory(folder_ / "plates");
    const fs::path key = folder_ / "plates/throw_16x9_key.jpg";
    fs::copy_file(kOurs / "plates/throw_4x3_key.jpg", key);
    EXPECT_NE(refusal().find("expected 1280 x 720 pixels as cameras.json says, found 1024 x 768"),
              std::string::npos);
    fs::resize_file(key, 5000);
    EXPECT_NE(refusal().find("expected a whole JPEG"), std::string::npos);
}

TEST_F(WorkshopFiles, ThatAreSpoiledGiveWayToTheProgramsOwnRoomAndLeaveAReason) {
    put("cameras.json", "{");
    OpenedScene opened = open_scene(folder_.path(), 640, 480);
    EXPECT_NE(opened.lack.find("cameras.json"), std::string::npos);
    const pot::Pot pot{.outer_mm = std::vector<float>(100, 50.0F), .height_mm = 200.0};
    EXPECT_NE(opened.scene->apply({.pot = &pot}, 640, 480).background, nullptr);
}

TEST_F(WorkshopFiles, ThatAreDamagedLeaveTheSmallStillLifeAndAReason) {
    put("cameras.json", "{");
    setenv("ONGGI_ASSETS", folder_.path().c_str(), 1);  // which has none in it
    OpenedScene opened = open_scene(folder_.path(), 640, 480);
    unsetenv("ONGGI_ASSETS");
    EXPECT_NE(opened.lack.find("cameras.json"), std::string::npos);
    const pot::Pot pot{.outer_mm = std::vector<float>(100, 50.0F), .height_mm = 200.0};
    const render::Scene& scene = opened.scene->apply({.pot = &pot}, 640, 480);
    EXPECT_EQ(scene.background, nullptr);
    EXPECT_GE(scene.still_life->parts.size(), 4U);
}

}  // namespace
}  // namespace onggi::wheel

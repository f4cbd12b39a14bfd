#include "game/wheel/workshop.h"

#include <gtest/gtest.h>

#include <fstream>

#include "engine/asset/gltf.h"
#include "game/wheel/wheel_scene.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/wheel/our_workshop.h"

namespace onggi::wheel {
namespace {

namespace fs = std::filesystem;

class ARoomModel : public testing::Test {
  protected:
    // One upright sheet, `metres` each way.
    fs::path sheet(const char* node, float metres) {
        asset::Mesh mesh;
        mesh.positions_m = {{0, 0, -1}, {metres, 0, -1}, {metres, metres, -1}, {0, metres, -1}};
        mesh.normals.assign(4, vec3(0.0F, 0.0F, 1.0F));
        mesh.indices = {0, 1, 2, 0, 2, 3};
        const auto bytes = asset::encode_glb(
            {.name = node,
             .generator = "test",
             .mesh = mesh,
             .material = {.name = "clay", .base_colour_linear = {0.4, 0.2, 0.1}, .roughness = 0.7},
             .extras = {}});
        EXPECT_TRUE(bytes);
        const fs::path file = folder_ / "sheet.glb";
        std::ofstream(file, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes->data()), static_cast<std::streamsize>(bytes->size()));
        return file;
    }

    const test::TemporaryFolder folder_;
};

TEST_F(ARoomModel, OfOurWorkshopHasItsWheelAndItsThings) {
    const auto room = load_room_model(kOurs / "room.glb");
    ASSERT_TRUE(room) << room.error().message;
    EXPECT_TRUE(room->has_wheel);
    EXPECT_GE(room->parts.size(), 20U);
}

TEST_F(ARoomModel, HasAWheelWhereANodeOrAMeshIsNamedSo) {
    for (const char* name :
         {"wheel", "Wheel.001", "wheel_head", "wheelhead", "WheelHead", "WHEEL-2", "wheel head"})
        EXPECT_TRUE(load_room_model(sheet(name, 1.2F))->has_wheel) << name;
    for (const char* name : {"wheelchair", "Wheelbarrow", "my wheel", "whee", ""})
        EXPECT_FALSE(load_room_model(sheet(name, 1.2F))->has_wheel) << name;
}

TEST_F(ARoomModel, IsInMillimetresAndPlainColours) {
    const auto room = load_room_model(sheet("jar", 1.2F));
    ASSERT_TRUE(room) << room.error().message;
    ASSERT_EQ(room->parts.size(), 1U);
    const StillPart& part = room->parts[0];
    EXPECT_FALSE(room->has_wheel);
    EXPECT_EQ(part.mesh->vertices.size(), 4U);
    EXPECT_NEAR(part.mesh->vertices[2].position_mm.y, 1200.0F, 0.01F);
    EXPECT_NEAR(part.material.albedo.x, 0.4F, 1e-6F);
    EXPECT_TRUE(part.casts_shadow);
}

TEST_F(ARoomModel, ShowsItsWallsFromBothSidesAndLetsThemCastNoShadow) {
    const auto room = load_room_model(sheet("wall", 3.0F));
    ASSERT_TRUE(room);
    const StillPart& wall = room->parts.at(0);
    EXPECT_EQ(wall.mesh->indices.size(), 12U);
    EXPECT_EQ(wall.mesh->vertices[4].normal, vec3(0.0F, 0.0F, -1.0F));
    EXPECT_FALSE(wall.casts_shadow);
}

TEST_F(ARoomModel, UsesTheWorkshopsCamerasAndLightIfItHasNone) {
    OpenedScene opened = open_scene(sheet("wall", 3.0F), 1280, 720);
    EXPECT_EQ(opened.lack, "");
    const pot::Pot pot{.outer_mm = std::vector<float>(100, 50.0F), .height_mm = 200.0};
    const render::Scene& scene = opened.scene->apply({.pot = &pot}, 1280, 720);
    EXPECT_EQ(scene.background, nullptr);
    EXPECT_EQ(scene.camera.eye_mm, vec3(0.0F, 285.0F, 805.0F));
    EXPECT_TRUE(scene.irradiance);
    EXPECT_EQ(scene.still_life->parts.size(), 3U) << "the wall, and our wheel and pan";
}

TEST_F(ARoomModel, RejectsAModelThatIsNotARoom) {
    const auto refusal = [](const fs::path& file) {
        const auto room = load_room_model(file);
        EXPECT_FALSE(room);
        return room ? std::string() : room.error().message;
    };
    EXPECT_NE(refusal(folder_ / "none.glb").find("no such file"), std::string::npos);
    std::ofstream(folder_ / "text.glb") << "solid cube";
    EXPECT_NE(refusal(folder_ / "text.glb").find("text.glb"), std::string::npos);
    EXPECT_NE(refusal(sheet("jar", 0.1F))
                  .find("expected a room of 1 to 100 m (glTF counts in metres), found 0.1 m"),
              std::string::npos);
    EXPECT_NE(refusal(sheet("hall", 2000.0F)).find("found 2e+03 m"), std::string::npos);
}

}  // namespace
}  // namespace onggi::wheel

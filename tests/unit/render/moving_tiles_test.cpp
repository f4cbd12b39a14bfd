#include "engine/render/shapes/moving_tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/render/shapes/lathe_edges.h"

namespace onggi::render {
namespace {

constexpr int kMovingWidth = 640;
constexpr int kMovingHeight = 360;

// A diagonal stick, most of whose bounding box is empty.
PropModel stick() {
    PropMesh mesh;
    for (int i = 0; i <= 200; ++i) {
        const float at = static_cast<float>(i);
        mesh.vertices.push_back({.position_mm = {at, at, 0.0F}});
        mesh.vertices.push_back({.position_mm = {at + 2.0F, at - 2.0F, 1.0F}});
        if (i == 0) continue;
        const auto last = static_cast<std::uint32_t>(2 * i);
        for (const std::uint32_t corner : {last - 2, last - 1, last, last - 1, last + 1, last})
            mesh.indices.push_back(corner);
    }
    PropModel model{.meshes = {mesh}, .boxes_mm = {}};
    measure(model);
    return model;
}

TEST(PropBoxes, HoldEveryTriangleAndLittleElse) {
    const PropModel model = stick();
    float volume_mm3 = 0.0F;
    for (const Box& box : model.boxes_mm) {
        const vec3 size = box.high - box.low;
        volume_mm3 += size.x * size.y * size.z;
    }
    EXPECT_LT(volume_mm3, 202.0F * 202.0F * 1.0F / 10.0F);
    const PropMesh& mesh = model.meshes[0];
    for (std::size_t at = 0; at < mesh.indices.size(); at += 3) {
        EXPECT_TRUE(std::any_of(model.boxes_mm.begin(), model.boxes_mm.end(), [&](const Box& box) {
            return std::all_of(mesh.indices.begin() + static_cast<std::ptrdiff_t>(at),
                               mesh.indices.begin() + static_cast<std::ptrdiff_t>(at) + 3,
                               [&](std::uint32_t corner) {
                                   const vec3 p = mesh.vertices[corner].position_mm;
                                   return glm::all(glm::lessThanEqual(box.low, p)) &&
                                          glm::all(glm::lessThanEqual(p, box.high));
                               });
        }));
    }
}

TEST(PropBoxes, AreEmptyWithoutTriangles) {
    PropModel nothing;
    measure(nothing);
    EXPECT_TRUE(nothing.boxes_mm.empty());
}

class MovingTiles : public testing::Test {
  protected:
    MovingTiles() {
        scene_.camera = {
            .eye_mm = {0.0F, 350.0F, 1100.0F}, .target_mm = {0.0F, 70.0F, 0.0F}, .vertical_fov_rad = 0.3F};
        scene_.lathe = Lathe{.radii_mm = radii_, .element_height_mm = 0.1F, .edge_rounding_mm = 2.0F};
        scene_.prop_library = std::make_shared<const PropLibrary>(PropLibrary{stick()});
        scene_.props = {{.model = 0, .place = glm::translate(mat4(1.0F), vec3(70.0F, 60.0F, 0.0F))}};
    }
    const std::vector<std::uint8_t>& find() {
        build_frame(scene_, {.lowest_mm = -100.0F}, live_desc(VK_FORMAT_R8G8B8A8_UNORM, true, kMovingHeight),
                    kMovingWidth, kMovingHeight, built_);
        if (built_.prop_tiles.empty()) want_stick();
        find_moving_tiles(scene_, {scene_.camera, kMovingWidth, kMovingHeight}, built_);
        return built_.moving_tiles;
    }
    // Marks the stick's tiles as its renderer does.
    void want_stick() {
        const TileGrid grid{kMovingWidth, kMovingHeight};
        built_.prop_tiles.assign(grid.count(), 0);
        for (const Box& box : (*scene_.prop_library)[0].boxes_mm) {
            const Box there = placed(box, scene_.props[0].place);
            want_tiles(grid, pixels_of({&there, 1}, scene_.camera, kMovingWidth, kMovingHeight),
                       built_.prop_tiles);
        }
    }
    // Whether the tile of a world point is marked.
    [[nodiscard]] bool holds(vec3 point) const {
        const Projector project({scene_.camera, kMovingWidth, kMovingHeight});
        const vec4 at = project(point);
        if (at.x < 0.0F || at.y < 0.0F || at.x >= kMovingWidth || at.y >= kMovingHeight) return true;
        const TileGrid grid{kMovingWidth, kMovingHeight};
        const int tile =
            static_cast<int>(at.y) / kTileHeightPx * grid.across() + static_cast<int>(at.x) / kTileWidthPx;
        return built_.moving_tiles[static_cast<std::size_t>(tile)] != 0;
    }

    std::vector<float> radii_ = std::vector<float>(1500, 60.0F);
    Scene scene_;
    BuiltFrame built_;
};

TEST_F(MovingTiles, ContainEveryPointOfThePotAndTheProps) {
    for (std::size_t i = 0; i < radii_.size(); ++i)
        radii_[i] = 50.0F + 25.0F * std::sin(0.005F * static_cast<float>(i));
    static_cast<void>(find());
    for (int turn = 0; turn < 360; ++turn) {
        const float angle = 0.0174533F * static_cast<float>(turn);
        for (std::size_t i = 0; i < radii_.size(); i += 10) {
            const vec3 point(radii_[i] * std::cos(angle), 0.1F * (static_cast<float>(i) + 0.5F),
                             radii_[i] * std::sin(angle));
            ASSERT_TRUE(holds(point)) << turn << " degrees, element " << i;
        }
    }
    for (const PropMesh::Vertex& vertex : (*scene_.prop_library)[0].meshes[0].vertices)
        ASSERT_TRUE(holds(vertex.position_mm + vec3(70.0F, 60.0F, 0.0F)));
}

TEST_F(MovingTiles, AreFewBesideAnArmThatLiesAslant) {
    const std::vector<std::uint8_t>& tiles = find();
    const auto count = std::count(tiles.begin(), tiles.end(), 1);
    EXPECT_LT(count, static_cast<std::ptrdiff_t>(tiles.size() / 4));
    EXPECT_GT(count, 50);
}

TEST_F(MovingTiles, HoldTheHandsThatTheHostDrew) {
    std::vector<std::uint8_t> tiles = find();
    const auto quiet = static_cast<std::size_t>(std::find(tiles.begin(), tiles.end(), 0) - tiles.begin());
    ASSERT_LT(quiet, tiles.size());
    built_.prop_tiles.assign(tiles.size(), 0);
    built_.prop_tiles[quiet] = 1;
    EXPECT_EQ(find()[quiet], 1);
    EXPECT_FALSE(holds(vec3(70.0F + 100.0F, 60.0F + 100.0F, 0.0F))) << "where the host drew none of it";
}

TEST_F(MovingTiles, AreAllOfThemWhereTheEyeIsInThePot) {
    scene_.camera.eye_mm = {0.0F, 60.0F, 40.0F};
    const std::vector<std::uint8_t>& tiles = find();
    EXPECT_EQ(std::count(tiles.begin(), tiles.end(), 0), 0);
}

}  // namespace
}  // namespace onggi::render

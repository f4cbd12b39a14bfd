#include "engine/render/shapes/moving_tiles.h"

#include <gtest/gtest.h>

#include "engine/render/shapes/frame_build.h"
#include "engine/render/shapes/lathe_mesh.h"
#include "tests/unit/render/lathe_samples.h"

namespace onggi::render {
namespace {

constexpr int kCoverWidth = 400;
constexpr int kCoverHeight = 300;

TEST(CoveredByLathe, IsNeverWiderThanThePot) {
    const Cylinder pot;
    const Lathe lathe = pot.lathe();
    const LatheProfile profile = pot.profile();
    const LatheSamples samples = samples_of(profile);
    const LatheRows chosen = choose_rows(profile, profile.inside, {});
    std::vector<shaders::RowData> rows;
    fill_rows(lathe, profile, samples, chosen, rows);
    std::vector<shaders::VertexData> vertices;
    fill_vertices({.lathe = lathe, .profile = profile, .samples = samples, .chosen = chosen, .rows = rows},
                  {}, even_sectors(lathe, 64), vertices);
    const Camera camera{.eye_mm = {0.0F, 200.0F, 700.0F}, .target_mm = {0.0F, 50.0F, 0.0F}};
    const std::vector<Covered> lines =
        covered_by_lathe(vertices, chosen.inside, 64, camera, kCoverWidth, kCoverHeight);
    ASSERT_EQ(lines.size(), static_cast<std::size_t>(kCoverHeight));
    int covered = 0;
    for (std::size_t y = 0; y < lines.size(); ++y) {
        if (lines[y].right <= lines[y].left) continue;
        ++covered;
        for (const float x : {lines[y].left + 1.0F, lines[y].right - 1.0F}) {
            // Whether the ray through that pixel passes within the cylinder's radius at a height of the
            // cylinder.
            const Ray ray = ray_through(camera, kCoverWidth, kCoverHeight, {x, static_cast<double>(y) + 0.5});
            bool meets = false;
            for (double t = 400.0; t < 1000.0 && !meets; t += 0.5) {
                const dvec3 at = ray.origin_mm + ray.direction * t;
                meets = at.y >= 0.0 && at.y <= 100.0 && std::hypot(at.x, at.z) <= 50.0;
            }
            EXPECT_TRUE(meets) << x << " " << y;
        }
    }
    EXPECT_GT(covered, 20);
    const Camera inside{.eye_mm = {0.0F, 50.0F, 60.0F}, .target_mm = {0.0F, 50.0F, 0.0F}};
    for (const Covered& line :
         covered_by_lathe(vertices, chosen.inside, 64, inside, kCoverWidth, kCoverHeight))
        EXPECT_LE(line.right, line.left) << "a pot about the eye covers nothing for sure";
}

}  // namespace
}  // namespace onggi::render

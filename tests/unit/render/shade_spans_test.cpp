#include "engine/render/shade_spans.h"

#include <gtest/gtest.h>

#include "engine/render/lathe_sectors.h"
#include "engine/render/lathe_vertices.h"
#include "tests/unit/render/lathe_samples.h"

namespace onggi::render {
namespace {

constexpr int kWidth = 400;
constexpr int kHeight = 300;

bool holds(const std::vector<vec4>& rects, float x, float y) {
    return std::any_of(rects.begin(), rects.end(), [&](const vec4& rect) {
        return x >= rect.x && x <= rect.z && y >= rect.y && y <= rect.w;
    });
}

TEST(ShadeRects, HoldEveryPixelOfTheOutlineAndLittleMore) {
    const std::vector<dvec2> triangle{{100.0, 40.0}, {320.0, 200.0}, {60.0, 260.0}};
    const std::vector<vec4> rects = shade_rects(triangle, {}, kWidth, kHeight);
    double area = 0.0;
    for (const vec4& rect : rects)
        area += static_cast<double>((rect.z - rect.x) * (rect.w - rect.y));
    const double inside = 0.5 * std::abs(220.0 * 220.0 - (-40.0) * 160.0);
    EXPECT_GE(area, inside);
    EXPECT_LT(area, inside * 1.12);
    for (int i = 0; i <= 40; ++i) {
        for (int j = 0; i + j <= 40; ++j) {
            const dvec2 at = (triangle[0] * static_cast<double>(i) + triangle[1] * static_cast<double>(j) +
                              triangle[2] * static_cast<double>(40 - i - j)) /
                             40.0;
            EXPECT_TRUE(holds(rects, static_cast<float>(at.x), static_cast<float>(at.y)))
                << at.x << " " << at.y;
        }
    }
}

TEST(ShadeRects, StayInsideThePictureAndAreNoneForNoOutline) {
    const std::vector<dvec2> huge{{-900.0, -900.0}, {900.0, -900.0}, {900.0, 900.0}, {-900.0, 900.0}};
    for (const vec4& rect : shade_rects(huge, {}, kWidth, kHeight)) {
        EXPECT_GE(rect.x, 0.0F);
        EXPECT_LE(rect.z, 400.0F);
        EXPECT_LE(rect.w, 300.0F);
    }
    EXPECT_TRUE(shade_rects({}, {}, kWidth, kHeight).empty());
}

TEST(ShadeRects, LeaveOutWhatThePotCovers) {
    const std::vector<dvec2> square{{100.0, 100.0}, {300.0, 100.0}, {300.0, 200.0}, {100.0, 200.0}};
    std::vector<Covered> covered(kHeight);
    for (std::size_t y = 130; y < 180; ++y)
        covered[y] = {150.0F, 250.0F};
    const std::vector<vec4> rects = shade_rects(square, covered, kWidth, kHeight);
    EXPECT_FALSE(holds(rects, 200.0F, 150.0F));
    EXPECT_TRUE(holds(rects, 120.0F, 150.0F));
    EXPECT_TRUE(holds(rects, 280.0F, 150.0F));
    EXPECT_TRUE(holds(rects, 200.0F, 110.0F));
    EXPECT_TRUE(holds(rects, 151.0F, 150.0F)) << "two pixels of margin at the pot's edge";
}

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
    const std::vector<Covered> lines = covered_by_lathe(vertices, chosen.inside, 64, camera, kWidth, kHeight);
    ASSERT_EQ(lines.size(), static_cast<std::size_t>(kHeight));
    int covered = 0;
    for (std::size_t y = 0; y < lines.size(); ++y) {
        if (lines[y].right <= lines[y].left) continue;
        ++covered;
        for (const float x : {lines[y].left + 1.0F, lines[y].right - 1.0F}) {
            // The ray through there passes within the cylinder's radius at some height of it.
            const Ray ray = ray_through(camera, kWidth, kHeight, {x, static_cast<double>(y) + 0.5});
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
    for (const Covered& line : covered_by_lathe(vertices, chosen.inside, 64, inside, kWidth, kHeight))
        EXPECT_LE(line.right, line.left) << "a pot about the eye covers nothing for sure";
}

}  // namespace
}  // namespace onggi::render

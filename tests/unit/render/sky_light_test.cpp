#include "engine/render/shapes/frame_build.h"

#include <gtest/gtest.h>

#include <cmath>

namespace onggi::render {
namespace {

vec3 diffuse(const std::array<vec3, 9>& c, vec3 n) {
    return c[0] + c[1] * n.y + c[2] * n.z + c[3] * n.x + c[4] * (n.x * n.y) + c[5] * (n.y * n.z) +
           c[6] * (3.0F * n.z * n.z - 1.0F) + c[7] * (n.x * n.z) + c[8] * (n.x * n.x - n.y * n.y);
}

TEST(SkyLight, GivesAnEvenSkyBackEvenly) {
    Environment sky;
    sky.zenith = sky.horizon = sky.nadir = vec3(0.7F, 0.5F, 0.3F);
    const auto coefficients = sky_irradiance(sky);
    for (const vec3 n : {vec3(0, 1, 0), vec3(1, 0, 0), glm::normalize(vec3(-1, -2, 3))}) {
        EXPECT_NEAR(diffuse(coefficients, n).x, 0.7F, 2e-3F);
        EXPECT_NEAR(diffuse(coefficients, n).z, 0.3F, 2e-3F);
    }
}

TEST(SkyLight, AgreesWithTheCosineIntegralOfASoftPanel) {
    Environment sky;
    sky.zenith = vec3(0.2F);
    sky.horizon = vec3(0.1F);
    sky.nadir = vec3(0.05F);
    sky.panels[0] = {glm::normalize(vec3(-0.6F, 0.5F, 0.3F)), vec3(1.0F), 3.0F};
    const auto coefficients = sky_irradiance(sky);
    for (const vec3 n : {vec3(0, 1, 0), vec3(-1, 0, 0), vec3(0, 0, 1), glm::normalize(vec3(1, 1, -1))}) {
        // The integral itself, over a finer grid of other points.
        double sum = 0.0;
        constexpr int kRows = 200;
        constexpr int kColumns = 300;
        for (int row = 0; row < kRows; ++row) {
            const float y = 1.0F - (static_cast<float>(row) + 0.5F) * 2.0F / kRows;
            for (int column = 0; column < kColumns; ++column) {
                const float angle = static_cast<float>(column) * 6.2831853F / kColumns;
                const float across = std::sqrt(1.0F - y * y);
                const vec3 d(across * std::cos(angle), y, across * std::sin(angle));
                sum += static_cast<double>(sky_radiance(sky, d).x * std::max(glm::dot(n, d), 0.0F));
            }
        }
        const auto exact = static_cast<float>(sum * 4.0 / (kRows * kColumns));
        EXPECT_NEAR(diffuse(coefficients, n).x, exact, 0.03F * exact + 0.005F);
    }
}

}  // namespace
}  // namespace onggi::render

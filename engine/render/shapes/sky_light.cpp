#include "engine/render/shapes/sky_light.h"

#include <cmath>
#include <numbers>

#include "shaders/sky.h"

namespace onggi::render {

vec3 sky_radiance(const Environment& environment, vec3 direction) {
    vec3 radiance = glm::mix(environment.horizon, direction.y > 0.0F ? environment.zenith : environment.nadir,
                             shaders::sky_height(direction.y));
    for (const Environment::Panel& panel : environment.panels)
        radiance +=
            panel.radiance * std::exp(panel.sharpness * (glm::dot(panel.direction, direction) - 1.0F));
    return radiance;
}

std::array<vec3, 9> sky_irradiance(const Environment& environment) {
    // Midpoint rule over the sphere; the sky is smooth, so a coarse grid is exact enough.
    constexpr int kRows = 32;
    constexpr int kColumns = 64;
    std::array<vec3, 9> coefficients{};
    for (int row = 0; row < kRows; ++row) {
        const float y = 1.0F - (static_cast<float>(row) + 0.5F) * 2.0F / kRows;
        const float across = std::sqrt(1.0F - y * y);
        for (int column = 0; column < kColumns; ++column) {
            const float angle =
                (static_cast<float>(column) + 0.5F) * 2.0F * std::numbers::pi_v<float> / kColumns;
            const vec3 d(across * std::cos(angle), y, across * std::sin(angle));
            const std::array<float, 9> basis{0.282095F,
                                             0.488603F * d.y,
                                             0.488603F * d.z,
                                             0.488603F * d.x,
                                             1.092548F * d.x * d.y,
                                             1.092548F * d.y * d.z,
                                             0.315392F * (3.0F * d.z * d.z - 1.0F),
                                             1.092548F * d.x * d.z,
                                             0.546274F * (d.x * d.x - d.y * d.y)};
            const vec3 radiance = sky_radiance(environment, d);
            for (std::size_t i = 0; i < basis.size(); ++i)
                coefficients[i] += radiance * basis[i];
        }
    }
    // Solid angle of a cell; the cosine lobe's factors over pi (1, 2/3, 1/4); the basis' own constants.
    constexpr float kCell = 4.0F * std::numbers::pi_v<float> / (kRows * kColumns);
    constexpr std::array<float, 9> kFold{0.282095F,         0.488603F * 2 / 3, 0.488603F * 2 / 3,
                                         0.488603F * 2 / 3, 1.092548F / 4,     1.092548F / 4,
                                         0.315392F / 4,     1.092548F / 4,     0.546274F / 4};
    for (std::size_t i = 0; i < kFold.size(); ++i)
        coefficients[i] *= kCell * kFold[i];
    return coefficients;
}

}  // namespace onggi::render

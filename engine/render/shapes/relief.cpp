#include "engine/render/shapes/relief.h"

#include <algorithm>

namespace onggi::render {
namespace {

constexpr double kMargin = 0.5;  // of the background

// From 0 to 1 over the background, and one step out at either end.
double fraction_of(int index, int corners) {
    if (index < 0) return -kMargin;
    if (index >= corners) return 1.0 + kMargin;
    return static_cast<double>(index) / (corners - 1);
}

Relief flat(const Camera& camera) {
    const float far_mm = 2.0F * glm::length(camera.target_mm - camera.eye_mm);
    return {.columns = 2, .rows = 2, .depth_mm = {far_mm, far_mm, far_mm, far_mm}};
}

}  // namespace

ReliefMesh relief_mesh(const Background& background) {
    const Relief relief = background.relief.depth_mm.empty() ? flat(background.camera) : background.relief;
    const int width = background.width_px;
    const int height = background.height_px;
    const dvec3 ahead = glm::normalize(dvec3(background.camera.target_mm) - dvec3(background.camera.eye_mm));
    ReliefMesh mesh;
    for (int row = -1; row <= relief.rows; ++row) {
        for (int column = -1; column <= relief.columns; ++column) {
            const dvec2 pixel(fraction_of(column, relief.columns) * width,
                              fraction_of(row, relief.rows) * height);
            const Ray ray = ray_through(background.camera, width, height, pixel);
            const int inside_row = std::clamp(row, 0, relief.rows - 1);
            const int inside_column = std::clamp(column, 0, relief.columns - 1);
            const auto depth = static_cast<double>(
                relief.depth_mm[static_cast<std::size_t>(inside_row * relief.columns + inside_column)]);
            mesh.positions_mm.emplace_back(ray.origin_mm +
                                           ray.direction * (depth / glm::dot(ray.direction, ahead)));
        }
    }
    const auto in_row = static_cast<std::uint32_t>(relief.columns + 2);
    for (std::uint32_t row = 0; row + 1 < static_cast<std::uint32_t>(relief.rows + 2); ++row) {
        for (std::uint32_t column = 0; column + 1 < in_row; ++column) {
            const std::uint32_t here = row * in_row + column;
            for (const std::uint32_t index :
                 {here, here + in_row, here + 1, here + 1, here + in_row, here + in_row + 1})
                mesh.indices.push_back(index);
        }
    }
    return mesh;
}

}  // namespace onggi::render

#include "engine/render/prop.h"

#include <algorithm>
#include <limits>
#include <span>

namespace onggi::render {
namespace {

constexpr Box kNothing{vec3(std::numeric_limits<float>::max()), vec3(std::numeric_limits<float>::lowest())};

Box about(const Box& a, const Box& b) {
    return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

// Recursively splits triangles, each given as its box, at the median of the longest axis, and appends the
// boxes.
void split(std::span<Box> triangles, int halvings, std::vector<Box>& boxes) {
    if (triangles.empty()) return;
    Box whole = kNothing;
    for (const Box& triangle : triangles)
        whole = about(whole, triangle);
    if (halvings == 0 || triangles.size() == 1) {
        boxes.push_back(whole);
        return;
    }
    const vec3 size = whole.high - whole.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto middle = triangles.begin() + static_cast<std::ptrdiff_t>(triangles.size() / 2);
    std::nth_element(triangles.begin(), middle, triangles.end(), [&](const Box& a, const Box& b) {
        return a.low[axis] + a.high[axis] < b.low[axis] + b.high[axis];
    });
    split({triangles.begin(), middle}, halvings - 1, boxes);
    split({middle, triangles.end()}, halvings - 1, boxes);
}

}  // namespace

void measure(PropModel& model) {
    constexpr int kHalvings = 5;
    std::vector<Box> triangles;
    for (const PropMesh& mesh : model.meshes) {
        for (std::size_t at = 0; at + 2 < mesh.indices.size(); at += 3) {
            Box box = kNothing;
            for (const std::uint32_t corner : std::span(mesh.indices).subspan(at, 3)) {
                const vec3 point = mesh.vertices[corner].position_mm;
                box = about(box, {point, point});
            }
            triangles.push_back(box);
        }
    }
    model.boxes_mm.clear();
    split(triangles, kHalvings, model.boxes_mm);
}

Box placed(const Box& box, const mat4& place) {
    Box around = kNothing;
    for (unsigned corner = 0; corner < 8; ++corner) {
        const vec3 at((corner & 1U) != 0 ? box.high.x : box.low.x,
                      (corner & 2U) != 0 ? box.high.y : box.low.y,
                      (corner & 4U) != 0 ? box.high.z : box.low.z);
        const vec3 point(place * vec4(at, 1.0F));
        around = about(around, {point, point});
    }
    return around;
}

}  // namespace onggi::render

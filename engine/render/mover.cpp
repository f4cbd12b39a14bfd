#include "engine/render/mover.h"

#include <limits>

namespace onggi::render {

void measure(MoverModel& model) {
    vec3 low(std::numeric_limits<float>::max());
    vec3 high(std::numeric_limits<float>::lowest());
    for (const MoverMesh& mesh : model.meshes) {
        for (const MoverMesh::Vertex& vertex : mesh.vertices) {
            low = glm::min(low, vertex.position_mm);
            high = glm::max(high, vertex.position_mm);
        }
    }
    if (low.x > high.x) low = high = vec3(0.0F);
    model.low_mm = low;
    model.high_mm = high;
}

PlacedBox placed_box(const MoverModel& model, const mat4& place) {
    PlacedBox box{vec3(std::numeric_limits<float>::max()), vec3(std::numeric_limits<float>::lowest())};
    for (unsigned corner = 0; corner < 8; ++corner) {
        const vec3 at((corner & 1U) != 0 ? model.high_mm.x : model.low_mm.x,
                      (corner & 2U) != 0 ? model.high_mm.y : model.low_mm.y,
                      (corner & 4U) != 0 ? model.high_mm.z : model.low_mm.z);
        const vec3 placed(place * vec4(at, 1.0F));
        box.low = glm::min(box.low, placed);
        box.high = glm::max(box.high, placed);
    }
    return box;
}

}  // namespace onggi::render

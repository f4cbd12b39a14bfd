// Props: everything that moves besides the lathe, i.e. hands and tools. Their meshes are loaded once and
// placed in every frame. Plain data, any thread. Lengths mm, colours linear light.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/math/math.h"

namespace onggi::render {

// Triangles, counter-clockwise seen from outside.
struct PropMesh {
    struct Vertex {
        vec3 position_mm{0.0F};
        vec3 normal{0.0F, 1.0F, 0.0F};
        // 0 to 255. tone: brightness of the colour, relative to 128. smear: how much of the smear covers it.
        // open_sky: ambient light that reaches it.
        std::uint8_t tone = 128;
        std::uint8_t smear = 0;
        std::uint8_t spare = 0;
        std::uint8_t open_sky = 255;
    };
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;

    // Albedo without a smear.
    vec3 albedo{0.5F};
    float roughness = 0.6F;  // GGX, 0.05 to 1
    float metalness = 0.0F;
};

// An axis-aligned box.
struct Box {
    vec3 low{0.0F};
    vec3 high{0.0F};
};

// One hand or tool: its meshes share a coordinate frame.
struct PropModel {
    std::vector<PropMesh> meshes;
    std::vector<Box> boxes_mm;  // their union contains every triangle, see measure()
};
// Fills in boxes_mm. Several boxes per model, because one box about a slanting arm would be mostly empty.
void measure(PropModel& model);

// All models that may be shown. Uploaded when a scene names another library; the contents never change.
using PropLibrary = std::vector<PropModel>;

// An instance of a model.
struct Prop {
    std::size_t model = 0;  // index into the scene's library; out of range: not drawn
    mat4 place{1.0F};       // rigid, with an optional mirror and uniform scale
    vec3 smear{0.3F};       // albedo of the smear, already darkened by its wetness
    float wetness = 0.0F;   // of the smear, 0 to 1
};

// Returns the axis-aligned box about a transformed box.
[[nodiscard]] Box placed(const Box& box, const mat4& place);

}  // namespace onggi::render

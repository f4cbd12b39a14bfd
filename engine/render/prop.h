// What moves besides the lathe: hands and tools, as meshes that are loaded once and placed every frame. Plain
// data, any thread. Lengths mm, colours linear light.
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
        // 0 to 255: brightness of the colour about 128; how much is smeared on it; unused; ambient light that
        // gets there.
        std::uint8_t tone = 128;
        std::uint8_t smear = 0;
        std::uint8_t spare = 0;
        std::uint8_t open_sky = 255;
    };
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;

    // Of the thing with nothing smeared on it.
    vec3 albedo{0.5F};
    float roughness = 0.6F;  // GGX, 0.05 to 1
    float metalness = 0.0F;
};

// Level, upright and square: along the axes.
struct Box {
    vec3 low{0.0F};
    vec3 high{0.0F};
};

// One tool: its meshes share a frame.
struct PropModel {
    std::vector<PropMesh> meshes;
    std::vector<Box> boxes_mm;  // together they hold every triangle, see measure()
};
// Boxes about parts of it, because about the whole of an arm that lies aslant most of a box is empty.
void measure(PropModel& model);

// All that may be shown. Uploaded when another one appears in a scene, and never during one.
using PropLibrary = std::vector<PropModel>;

// One of them, somewhere.
struct Prop {
    std::size_t model = 0;  // of the scene's library; beyond it: not drawn
    mat4 place{1.0F};       // rigid, but for a mirror and one scale
    vec3 smear{0.3F};       // albedo of what lies on it, as dark as it is wet
    float wetness = 0.0F;   // of that, 0 to 1
};

// The box about a box that is placed.
[[nodiscard]] Box placed(const Box& box, const mat4& place);

}  // namespace onggi::render

// Reads the triangles and plain materials of a glTF 2.0 file in its binary form, GLB (ISO/IEC 12113): tools
// and rooms from a script or a museum. Any thread but the haptic one; takes bytes, touches no file and
// follows no reference to another file. The bytes are not trusted: anything invalid is refused.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/asset/gltf.h"
#include "engine/asset/mesh.h"
#include "engine/core/result.h"

namespace onggi::asset {

// The limits of a file, far above a real room.
struct GltfLimits {
    std::size_t max_bytes = std::size_t{256} << 20;
    std::size_t max_vertices = std::size_t{1} << 22;
    std::size_t max_triangles = std::size_t{1} << 22;
    std::size_t max_nodes = 1 << 14;  // visited nodes, so that a small file cannot expand without bound
    int max_depth = 64;               // of nodes below a scene, and of brackets in the JSON
};

// One primitive of a node, transformed by the node and its ancestors.
struct GltfPart {
    std::string node;       // its name; may be empty
    std::string mesh_name;  // may be empty
    Mesh mesh;              // metres, +Y up, counter-clockwise from outside, even below a mirroring node
    // COLOR_0 as linear red, green, blue, alpha; empty if the file has none, otherwise one per vertex.
    std::vector<vec4> colours;
    int material = -1;  // index into GltfModel::materials; -1: glTF's default, white and rough
};

struct GltfModel {
    std::vector<Material> materials;  // factors only, textures are not read
    std::vector<GltfPart> parts;      // in the order of the scene's nodes; at least one
    // parts that are not drawn, each once, for example "mesh 'grid': lines"
    std::vector<std::string> left_out;
};

// Reads the default scene, or the first; in a file without scenes, all root nodes. Triangles, strips and fans
// are read. Points and lines are left out, and so are extensions of the surface (KHR_materials_*, textures,
// lights), even if the file requires them. Errors call the file `name`. kBadInput for anything but a whole
// GLB with triangles within the limits, including sparse or compressed accessors, other required extensions,
// and buffers or images outside the file. Missing normals are computed, smooth across shared vertices.
Result<GltfModel> decode_glb(std::span<const std::byte> bytes, std::string_view name,
                             const GltfLimits& limits = {});

}  // namespace onggi::asset

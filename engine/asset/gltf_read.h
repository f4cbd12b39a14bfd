// Reads the triangles and plain materials of a glTF 2.0 file in its binary form, GLB (ISO/IEC 12113): tools
// and rooms that a script or a museum made. Any thread but the haptic one; takes bytes and touches no file,
// and follows no reference out of the file. Bytes may come from anywhere: whatever does not fit is refused.
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

// What one file may hold at most; a real GPU's room fits many times.
struct GltfLimits {
    std::size_t max_bytes = std::size_t{256} << 20;
    std::size_t max_vertices = std::size_t{1} << 22;
    std::size_t max_triangles = std::size_t{1} << 22;
    std::size_t max_nodes = 1 << 14;  // visited, so that a file cannot unfold into a giant
    int max_depth = 64;               // of nodes below a scene, and of brackets in the JSON
};

// One primitive of one node, placed by all the nodes above it.
struct GltfPart {
    std::string node;       // its name; may be empty
    std::string mesh_name;  // may be empty
    Mesh mesh;         // metres, +Y up, counter-clockwise from outside also below a mirroring node
    // COLOR_0 as linear red, green, blue, alpha; empty where the file has none, else one a vertex.
    std::vector<vec4> colours;
    int material = -1;  // of GltfModel::materials; -1: glTF's default, white and rough
};

struct GltfModel {
    std::vector<Material> materials;  // textures are left out: only the factors are read
    std::vector<GltfPart> parts;      // in the order of the scene's nodes; at least one
    std::vector<std::string> left_out;  // "mesh 'grid': lines", each once: what is there and is not drawn
};

// The default scene, or the first; of a file without scenes, all nodes that are nobody's child. Triangles, strips and fans
// are read; points and lines are left out, and so are extensions of the surface (KHR_materials_*, textures, lights), even
// where the file requires them. `name` is what an error calls the file. kBadInput for anything but a whole GLB with triangles
// within the limits: also sparse or compressed accessors, other extensions that the file requires, and buffers or images
// outside the file. Missing normals are made, smooth across shared vertices.
Result<GltfModel> decode_glb(std::span<const std::byte> bytes, std::string_view name,
                             const GltfLimits& limits = {});

}  // namespace onggi::asset

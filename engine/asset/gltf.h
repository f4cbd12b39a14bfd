// Writes glTF 2.0 in its binary form, GLB (ISO/IEC 12113). Any thread; returns bytes and touches no file:
// tinygltf 2.7 reports success for a file that it could not open (findings/), so engine/files writes the
// bytes.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "engine/asset/about.h"
#include "engine/asset/mesh.h"
#include "engine/core/result.h"

namespace onggi::asset {

// A second, clear layer over a material: water or glaze (KHR_materials_clearcoat, ratified).
struct Clearcoat {
    double factor = 0.0;  // 0: no coat, and the file omits the extension
    double roughness = 0.0;
};

// The material's textures, as whole files (PNG or JPEG), mapped by the mesh's uvs; empty: no texture. Their
// values are multiplied by the material's factors.
struct Textures {
    std::vector<std::byte> base_colour{};  // sRGB
    std::vector<std::byte> normal{};       // tangent space, green up
    std::vector<std::byte> surface{};      // red: occlusion, green: roughness, blue: metal
    std::vector<std::byte> clearcoat{};    // red: amount of clearcoat

    [[nodiscard]] bool are_there() const {
        return !base_colour.empty() || !normal.empty() || !surface.empty() || !clearcoat.empty();
    }
};

// The metallic-roughness material of glTF 2.0, section 3.9.2.
struct Material {
    std::string name;
    dvec3 base_colour_linear{1.0};  // linear Rec. 709 reflectance, 0 to 1
    double roughness = 1.0;         // 0 mirror to 1 matt
    double metallic = 0.0;
    Clearcoat clearcoat = {};
    Textures textures = {};
};

// A field of the extras of asset and node, which a museum's database can read without a 3D library. Both have
// them, because optimisers keep the asset's alone
// (findings/gltfpack-drops-the-copyright-and-keeps-the-extras.sh), and Blender the node's alone.
using Extra = std::pair<std::string, std::variant<double, std::string, std::vector<double>>>;

// One mesh of one material at the origin of one scene.
struct GltfContent {
    std::string name;       // of scene, node and mesh; any bytes, made valid UTF-8
    std::string generator;  // program and version
    Mesh mesh;
    Material material;
    std::vector<Extra> extras;
    // asset.copyright; with rights or a publisher also KHR_xmp_json_ld, of which Khronos's validator says
    // that it cannot check it.
    About about{};
};

// The same content gives the same bytes. Indices take 16 bits while the vertices allow it. kBadInput if the
// mesh is empty, an index points past the vertices, the number of normals differs from that of vertices, or a
// number is not finite; kFailed if the library fails.
Result<std::vector<std::byte>> encode_glb(const GltfContent& content);

}  // namespace onggi::asset

// Any bytes are refused or are a GLB of triangles that can be drawn; also as two chunks of correct lengths:
// up to the first NUL the JSON, after it the numbers.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/asset/gltf_read.h"
#include "tests/fuzz/fuzz_expect.h"
#include "tests/support/glb_builder.h"

namespace {

using namespace onggi;  // NOLINT: one small program

// Small limits, so that an expanding file reaches them soon.
constexpr asset::GltfLimits kLimits{.max_bytes = 1 << 16,
                                    .max_vertices = 1 << 12,
                                    .max_triangles = 1 << 12,
                                    .max_nodes = 256,
                                    .max_depth = 16};

bool is_finite(const vec3& value) {
    return std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z);
}

void read(std::span<const std::byte> bytes) {
    const auto model = asset::decode_glb(bytes, "fuzz", kLimits);
    if (!model) {
        fuzz::expect(model.error().kind == ErrorKind::kBadInput);
        fuzz::expect(model.error().message.find('\n') == std::string::npos);
        return;
    }
    fuzz::expect(!model->parts.empty());
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    for (const asset::GltfPart& part : model->parts) {
        const asset::Mesh& mesh = part.mesh;
        vertices += mesh.positions_m.size();
        triangles += mesh.triangle_count();
        fuzz::expect(mesh.normals.size() == mesh.positions_m.size());
        fuzz::expect(part.colours.empty() || part.colours.size() == mesh.positions_m.size());
        fuzz::expect(std::all_of(mesh.positions_m.begin(), mesh.positions_m.end(), is_finite));
        fuzz::expect(std::all_of(mesh.normals.begin(), mesh.normals.end(), is_finite));
        fuzz::expect(mesh.indices.size() % 3 == 0);
        fuzz::expect(std::all_of(mesh.indices.begin(), mesh.indices.end(),
                                 [&](std::uint32_t index) { return index < mesh.positions_m.size(); }));
        fuzz::expect(part.material >= -1 && part.material < static_cast<int>(model->materials.size()));
    }
    fuzz::expect(vertices <= kLimits.max_vertices && triangles <= kLimits.max_triangles);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto bytes = std::as_bytes(std::span(data, size));
    read(bytes);
    const auto nul = std::find(bytes.begin(), bytes.end(), std::byte{0});
    const auto json_bytes = static_cast<std::size_t>(nul - bytes.begin());
    const auto binary = bytes.subspan(std::min(json_bytes + 1, size));
    read(test::glb_of(std::string(reinterpret_cast<const char*>(data), json_bytes),
                      std::vector<std::byte>(binary.begin(), binary.end())));
    return 0;
}

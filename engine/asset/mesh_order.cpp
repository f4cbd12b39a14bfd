// See mesh_order.h. The only file that includes meshoptimizer. Any thread.
#include "engine/asset/mesh_order.h"

#include <meshoptimizer.h>

namespace onggi::asset {
namespace {

template <typename Vector>
void put_in_order(std::vector<Vector>& vectors, const std::vector<unsigned int>& places) {
    if (vectors.empty()) return;
    meshopt_remapVertexBuffer(vectors.data(), vectors.data(), vectors.size(), sizeof(Vector), places.data());
}

}  // namespace

void order_for_drawing(Mesh& mesh) {
    const std::size_t count = mesh.positions_m.size();
    meshopt_optimizeVertexCache(mesh.indices.data(), mesh.indices.data(), mesh.indices.size(), count);
    std::vector<unsigned int> places(count);
    meshopt_optimizeVertexFetchRemap(places.data(), mesh.indices.data(), mesh.indices.size(), count);
    put_in_order(mesh.positions_m, places);
    put_in_order(mesh.normals, places);
    put_in_order(mesh.uvs, places);
    put_in_order(mesh.tangents, places);
    meshopt_remapIndexBuffer(mesh.indices.data(), mesh.indices.data(), mesh.indices.size(), places.data());
}

std::vector<std::uint32_t> thinned(std::span<const vec3> positions, std::span<const std::uint32_t> indices,
                                   double fraction) {
    if (indices.empty()) return {};
    constexpr std::size_t kCorners = 3;
    constexpr float kMostError = 1.0F;  // of the mesh's size: the fraction alone ends the thinning
    const auto wanted =
        kCorners * static_cast<std::size_t>(fraction * static_cast<double>(indices.size() / kCorners));
    std::vector<std::uint32_t> left(indices.size());
    left.resize(meshopt_simplify(left.data(), indices.data(), indices.size(), &positions.front().x,
                                 positions.size(), sizeof(vec3), wanted, kMostError,
                                 meshopt_SimplifyLockBorder));
    return left;
}

}  // namespace onggi::asset

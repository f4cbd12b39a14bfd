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

}  // namespace onggi::asset

#include "engine/render/mover_models.h"

#include <span>

#include "engine/render/mover_faces.h"

namespace onggi::render {

Result<void> MoverModels::upload(const vk::Device& device,
                                 const std::shared_ptr<const MoverLibrary>& library) {
    if (library == uploaded_) return {};
    uploaded_.reset();
    ranges_.clear();
    std::vector<MoverMesh::Vertex> vertices;
    std::vector<std::uint32_t> indices;
    for (const MoverModel& model : library ? *library : MoverLibrary()) {
        std::vector<Range>& ranges = ranges_.emplace_back();
        for (const MoverMesh& mesh : model.meshes) {
            ranges.push_back({.first_index = static_cast<std::uint32_t>(indices.size()),
                              .index_count = static_cast<std::uint32_t>(mesh.indices.size()),
                              .first_vertex = static_cast<std::int32_t>(vertices.size()),
                              .planes = face_planes(mesh),
                              .edges = mesh_edges(mesh)});
            vertices.insert(vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
            indices.insert(indices.end(), mesh.indices.begin(), mesh.indices.end());
        }
    }
    auto sent = buffers_.upload(device, "hands and tools", std::as_bytes(std::span(vertices)), indices);
    if (!sent) return sent;
    uploaded_ = library;
    return {};
}

const std::vector<MoverModels::Range>& MoverModels::ranges(std::size_t model) const {
    static const std::vector<Range> nothing;
    return model < ranges_.size() ? ranges_[model] : nothing;
}

}  // namespace onggi::render

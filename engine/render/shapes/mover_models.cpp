#include "engine/render/shapes/mover_models.h"

#include <optional>

#include "engine/render/shapes/mover_faces.h"

namespace onggi::render {

void MoverModels::learn(const std::shared_ptr<const MoverLibrary>& library) {
    if (library == library_) return;
    library_ = library;
    known_.clear();
    for (const MoverModel& model : library ? *library : MoverLibrary()) {
        std::vector<Known>& known = known_.emplace_back();
        for (const MoverMesh& mesh : model.meshes)
            known.push_back({.planes = face_planes(mesh), .edges = mesh_edges(mesh)});
    }
}

std::span<const MoverModels::Known> MoverModels::known_of(std::size_t model) const {
    return model < known_.size() ? std::span<const Known>(known_[model]) : std::span<const Known>();
}

void MoverModels::choose(const Scene& scene, const RendererDesc& desc, const EdgeView& view,
                         BuiltFrame& built) {
    learn(scene.mover_library);
    chosen_.clear();
    chosen_indices_.clear();
    if (desc.draws_hidden_faces && !desc.smooths_outlines) return;
    std::optional<InsidePot> inside;
    if (scene.lathe) inside.emplace(*scene.lathe, built.samples, scene.camera.eye_mm);
    const InsidePot* const pot = inside ? &*inside : nullptr;
    for (const Mover& mover : scene.movers) {
        const std::span<const Known> known = known_of(mover.model);
        for (std::size_t mesh = 0; mesh < known.size(); ++mesh) {
            const PlacedMesh placed{(*library_)[mover.model].meshes[mesh], known[mesh].planes, mover.place};
            const std::vector<std::uint8_t> towards_eye = faces_towards(placed, scene.camera.eye_mm);
            if (desc.smooths_outlines)
                add_mover_edges(placed, towards_eye, known[mesh].edges, pot, view, built.edges);
            if (desc.draws_hidden_faces) continue;
            const std::size_t first = chosen_indices_.size();
            choose_mover_faces(placed, towards_eye, pot, chosen_indices_);
            chosen_.push_back({first, chosen_indices_.size() - first});
        }
    }
}

}  // namespace onggi::render

#include "engine/render/shapes/prop_models.h"

#include <optional>

#include "engine/render/shapes/prop_faces.h"

namespace onggi::render {

void PropModels::learn(const std::shared_ptr<const PropLibrary>& library) {
    if (library == library_) return;
    library_ = library;
    known_.clear();
    for (const PropModel& model : library ? *library : PropLibrary()) {
        std::vector<Known>& known = known_.emplace_back();
        for (const PropMesh& mesh : model.meshes)
            known.push_back({.planes = face_planes(mesh), .edges = mesh_edges(mesh)});
    }
}

std::span<const PropModels::Known> PropModels::known_of(std::size_t model) const {
    return model < known_.size() ? std::span<const Known>(known_[model]) : std::span<const Known>();
}

void PropModels::choose(const Scene& scene, const RendererDesc& desc, const EdgeView& view,
                        BuiltFrame& built) {
    learn(scene.prop_library);
    chosen_.clear();
    chosen_indices_.clear();
    if (desc.draws_hidden_faces && !desc.smooths_outlines) return;
    std::optional<InsidePot> inside;
    if (scene.lathe) inside.emplace(*scene.lathe, built.samples, scene.camera.eye_mm);
    const InsidePot* const pot = inside ? &*inside : nullptr;
    for (const Prop& prop : scene.props) {
        const std::span<const Known> known = known_of(prop.model);
        for (std::size_t mesh = 0; mesh < known.size(); ++mesh) {
            const PlacedMesh placed{(*library_)[prop.model].meshes[mesh], known[mesh].planes, prop.place};
            const std::vector<std::uint8_t> towards_eye = faces_towards(placed, scene.camera.eye_mm);
            if (desc.smooths_outlines)
                add_prop_edges(placed, towards_eye, known[mesh].edges, pot, view, built.edges);
            if (desc.draws_hidden_faces) continue;
            const std::size_t first = chosen_indices_.size();
            choose_prop_faces(placed, towards_eye, pot, chosen_indices_);
            chosen_.push_back({first, chosen_indices_.size() - first});
        }
    }
}

}  // namespace onggi::render

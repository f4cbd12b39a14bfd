#include "engine/render/mover_pass.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include "engine/render/profile_mesh.h"
#include "shaders/shaders.h"

namespace onggi::render {
namespace {

constexpr std::array kAttributes{
    VkVertexInputAttributeDescription{0, 0, VK_FORMAT_R32G32B32_SFLOAT,
                                      offsetof(MoverMesh::Vertex, position_mm)},
    VkVertexInputAttributeDescription{1, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(MoverMesh::Vertex, normal)},
    VkVertexInputAttributeDescription{2, 0, VK_FORMAT_R8G8B8A8_UNORM, offsetof(MoverMesh::Vertex, tone)}};

shaders::MoverDraw mover_draw(const Mover& mover, const MoverMesh& mesh) {
    const mat4 rows = glm::transpose(mover.place);  // a column of the transposed is a row
    return {.row_x = rows[0],
            .row_y = rows[1],
            .row_z = rows[2],
            .albedo = vec4(mesh.albedo, mesh.roughness),
            .clay = vec4(mover.clay, mover.wetness),
            .surface = vec4(mesh.metalness, 0.0F, 0.0F, 0.0F)};
}

}  // namespace

Result<void> MoverPass::create(const FrameContext& frame) {
    if (!frame.desc.cached) {
        if (auto created = create_pipeline(frame); !created) return created;
    }
    StillLife ball;
    ball.parts.push_back({.mesh = std::make_shared<const Mesh>(sphere_mesh(24, 40)), .material = {}});
    return sphere_.upload(frame.device, ball);
}

Result<void> MoverPass::create_pipeline(const FrameContext& frame) {
    const std::array constants{static_cast<std::uint32_t>(frame.desc.transfer)};
    const std::array formats{frame.desc.colour_format};
    const bool at_vertices = frame.desc.lights_movers_at_vertices;
    auto pipeline = vk::create_pipeline(
        frame.device, {.name = "hands and tools",
                       .vertex_spirv = at_vertices ? shaders::kMoverLitVert : shaders::kMoverVert,
                       .fragment_spirv = at_vertices ? shaders::kMoverLitFrag : shaders::kMoverFrag,
                       .constants = constants,
                       .layout = frame.pipelines.layout.get(),
                       .attributes = kAttributes,
                       .vertex_stride = sizeof(MoverMesh::Vertex),
                       .colour_formats = formats,
                       .depth_format = kDepthFormat,
                       .samples = static_cast<VkSampleCountFlagBits>(frame.desc.samples),
                       .depth_test = true,
                       .depth_write = true});
    if (!pipeline) return pipeline.error();
    pipeline_ = std::move(*pipeline);
    return {};
}

Result<void> MoverPass::fit(const FrameContext& frame, const Scene& scene) {
    return models_.upload(frame.device, scene.mover_library);
}

Result<void> MoverPass::upload(FrameContext& frame, const Scene& scene) {
    chosen_.clear();
    chosen_indices_.clear();
    const bool smooths = frame.desc.cached && frame.desc.smooths_outlines;
    if (!(frame.desc.chooses_mover_faces || smooths) || !scene.mover_library) return {};
    const EdgeView view{scene.camera, static_cast<int>(frame.extent.width),
                        static_cast<int>(frame.extent.height)};
    std::optional<InsidePot> inside;
    if (scene.lathe) inside.emplace(*scene.lathe, frame.built.samples, scene.camera.eye_mm);
    const InsidePot* const pot = inside ? &*inside : nullptr;
    for (const Mover& mover : scene.movers) {
        const std::vector<MoverModels::Range>& ranges = models_.ranges(mover.model);
        for (std::size_t mesh = 0; mesh < ranges.size(); ++mesh) {
            const PlacedMesh placed{(*scene.mover_library)[mover.model].meshes[mesh], ranges[mesh].planes,
                                    mover.place};
            const std::vector<std::uint8_t> towards_eye = faces_towards(placed, scene.camera.eye_mm);
            if (smooths)
                add_mover_edges(placed, towards_eye, ranges[mesh].edges, pot, view, frame.built.edges);
            if (!frame.desc.chooses_mover_faces) continue;
            const auto first = static_cast<std::uint32_t>(chosen_indices_.size());
            choose_mover_faces(placed, towards_eye, pot, chosen_indices_);
            chosen_.push_back({first, static_cast<std::uint32_t>(chosen_indices_.size()) - first});
        }
    }
    if (chosen_indices_.empty() || frame.desc.cached) return {};
    const auto bytes = std::as_bytes(std::span(chosen_indices_));
    if (auto made = vk::make_room(frame.device, chosen_buffer_, "hands' and tools' faces", bytes.size(),
                                  VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
        !made) {
        return made;
    }
    frame.write(chosen_buffer_, bytes);
    return {};
}

void MoverPass::draw(const FrameContext& frame, const Scene& scene) const {
    const std::size_t count = std::min<std::size_t>(scene.spheres.size(), kMaxSpheres);
    const auto first = scene.spheres.begin();
    const auto shown = [](const Sphere& ball) { return ball.shown; };
    if (std::any_of(first, first + static_cast<std::ptrdiff_t>(count), shown)) {
        frame.bind(frame.pipelines.mover);
        for (std::size_t i = 0; i < count; ++i) {
            const Sphere& ball = scene.spheres[i];
            if (!ball.shown) continue;
            sphere_.draw_as(frame.commands, frame.pipelines.layout.get(),
                            mesh_draw(ball.material, ball.centre_mm, ball.radius_mm));
        }
    }
    if (!frame.desc.cached) draw_models(frame, scene);
}

void MoverPass::draw_models(const FrameContext& frame, const Scene& scene) const {
    if (scene.movers.empty() || !scene.mover_library) return;
    frame.bind(pipeline_);
    models_.bind(frame.commands);
    if (!chosen_indices_.empty())
        vkCmdBindIndexBuffer(frame.commands, chosen_buffer_.handle(), 0, VK_INDEX_TYPE_UINT32);
    std::size_t number = 0;
    for (const Mover& mover : scene.movers) {
        const std::vector<MoverModels::Range>& ranges = models_.ranges(mover.model);
        for (std::size_t mesh = 0; mesh < ranges.size(); ++mesh) {
            const Drawn drawn = frame.desc.chooses_mover_faces
                                    ? chosen_[number++]
                                    : Drawn{ranges[mesh].first_index, ranges[mesh].index_count};
            if (drawn.index_count == 0) continue;
            frame.push(mover_draw(mover, (*scene.mover_library)[mover.model].meshes[mesh]));
            vkCmdDrawIndexed(frame.commands, drawn.index_count, 1, drawn.first_index,
                             ranges[mesh].first_vertex, 0);
        }
    }
}

}  // namespace onggi::render

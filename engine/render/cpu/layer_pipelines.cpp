#include "engine/render/cpu/layer_pipelines.h"

#include <array>
#include <span>

#include "engine/render/frame/pipelines.h"
#include "shaders/shaders.h"

namespace onggi::render {

Result<void> create_pipelines(const FrameContext& frame, LayerPipelines& pipelines) {
    const std::array formats{frame.desc.colour_format, kPackedFormat};
    vk::PipelineDesc places = mesh_pipeline(frame, "places of the still life", shaders::kPlacesFrag);
    places.vertex_spirv = shaders::kBackgroundSurfaceVert;
    places.attributes = std::span(kMeshAttributes).first(2);
    places.colour_formats = formats;
    PipelineMaker maker(frame.device);
    maker.make(pipelines.places, places);
    return maker.outcome();
}

Result<void> fit_pipelines(const FrameContext& frame, const Scene& scene, LayerPipelines& pipelines) {
    if (scene.background) return {};
    const std::array formats{frame.desc.colour_format, frame.desc.colour_format, kPackedFormat};
    vk::PipelineDesc backdrop = screen_pipeline(frame, "backdrop", shaders::kBackdropLayersFrag);
    backdrop.colour_formats = formats;
    vk::PipelineDesc still = mesh_pipeline(frame, "still life", shaders::kMeshLayersFrag);
    still.colour_formats = formats;
    PipelineMaker maker(frame.device);
    maker.make(pipelines.backdrop, backdrop);
    maker.make(pipelines.still, still);
    return maker.outcome();
}

}  // namespace onggi::render

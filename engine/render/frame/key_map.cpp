#include "engine/render/frame/key_map.h"

namespace onggi::render {

void record_key_map(const FrameContext& frame, const StillMeshes& meshes) {
    const vk::Image& map = frame.images.key_map;
    vk::barrier(frame.commands, map, vk::state::kDiscard, vk::state::kDepth);
    begin_pass(frame.commands, map.extent(), {}, {.view = map.view(), .store = VK_ATTACHMENT_STORE_OP_STORE});
    frame.bind(frame.pipelines.key_map);
    meshes.draw(frame.commands, frame.pipelines.layout.get(), StillMeshes::Which::kCasters);
    vkCmdEndRendering(frame.commands);
    vk::barrier(frame.commands, map, vk::state::kDepth, vk::state::kSampled);
}

}  // namespace onggi::render

// The shadow map of a still life in its own colours: what stands still casts on itself. Main thread.
#pragma once

#include "engine/core/result.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/frame/still_meshes.h"

namespace onggi::render {

// Its pipeline, where there is none yet.
Result<void> fit_shadow_map(FrameContext& frame);
// Into the frame's shadow_map, in commands that are outside of any pass.
void record_shadow_map(const FrameContext& frame, const StillMeshes& meshes);

}  // namespace onggi::render

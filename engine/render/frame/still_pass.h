// The background: what stands still. With cached layers it is drawn once and kept where the processor shades
// it; without, it is drawn into every frame. Main thread.
#pragma once

#include <cstdint>
#include <memory>

#include "engine/core/result.h"
#include "engine/render/frame/frame_context.h"
#include "engine/render/frame/plate_pass.h"
#include "engine/render/frame/still_layers.h"
#include "engine/render/frame/still_meshes.h"

namespace onggi::render {

class StillPass {
  public:
    // The still life of the scene and its plate onto the device, if they are others. The device is idle.
    Result<void> fit(const FrameContext& frame, const Scene& scene);
    // Decides whether the still life has to be drawn, or its layers again, and notes it in the stats.
    void update(FrameContext& frame, const Scene& scene);

    // Cached, and the camera stands: draws the layers if update() asked for it, and waits for them. The
    // frame's uniforms are written over. The device is idle.
    Result<void> draw_layers(FrameContext& frame, const Scene& scene);
    // Cached: whether the layers show this scene.
    [[nodiscard]] bool shows(const FrameContext& frame, const Scene& scene) const;
    [[nodiscard]] const StillLayers& layers() const { return layers_; }
    // Cached: no layers are needed for a while. The device is idle.
    void let_go_layers();

    // Direct: the still life's shadow map.
    void record(const FrameContext& frame) const;
    // Direct: meshes and backdrop inside the caller's pass; front to back, so after what stands before them.
    void draw(const FrameContext& frame) const;
    // The same while the camera moves between plates.
    void draw_gliding(const FrameContext& frame, const Glide& glide) const;

    [[nodiscard]] const PlatePass& plates() const { return plate_; }
    [[nodiscard]] const StillBounds& bounds() const { return still_.bounds(); }

  private:
    void record_key_map(const FrameContext& frame) const;

    PlatePass plate_;
    bool has_plate_ = false;
    bool is_gliding_ = false;
    std::size_t glide_need_ = kGlideAlone;
    StillMeshes still_;
    StillLayers layers_;
    std::shared_ptr<const StillLife> uploaded_;  // held, so that its revision is compared with itself
    std::uint64_t uploaded_revision_ = 0;
    std::uint64_t drawn_ = 0;  // hash of what the layers show
    bool has_layers_ = false;
};

}  // namespace onggi::render
